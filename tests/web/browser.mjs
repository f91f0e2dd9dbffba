// Debian's Chromium, with software WebGL and an empty profile, that may reach nothing.
import { mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** The browser that the tests use. */
export const chromiumPath = process.env.BODYLINE_CHROMIUM ?? '/usr/bin/chromium';

const flags = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

/**
 * @param {string} packages folder in which the packages of web/ are installed
 * @param {{width?: number, height?: number, colorScheme?: 'light' | 'dark', scale?: number}} [screen]
 */
export async function openBrowser(packages, { width = 1280, height = 800, colorScheme = 'light', scale = 1 } = {}) {
  const { chromium } = createRequire(join(packages, 'package.json'))('playwright-core');
  const profile = mkdtempSync(join(tmpdir(), 'bodyline-browser-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: chromiumPath,
    headless: true,
    args: flags,
    viewport: { width, height },
    colorScheme,
    deviceScaleFactor: scale,
    acceptDownloads: true,
  });
  return {
    context,
    async close() {
      await context.close();
      rmSync(profile, { recursive: true, force: true });
    },
  };
}

/**
 * Opens a page from a file. `problems` gathers errors of its scripts and whatever it asks the network for.
 * @param {import('playwright-core').BrowserContext} context
 */
export async function openPage(context, path) {
  const page = await context.newPage();
  const problems = [];
  page.on('pageerror', (error) => problems.push(`error: ${error.message}`));
  page.on('console', (message) => message.type() === 'error' && problems.push(`console: ${message.text()}`));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) problems.push(`request: ${request.url()}`);
  });
  await page.goto(`file://${path}`);
  await page.waitForSelector('html[data-ready]', { timeout: 20000 });
  return { page, problems };
}
