// A dialog with a variant as text, to be copied.
import { element } from '../dom.js';
import { listTable, modelCommand, setCommand } from './texts.js';

async function copy(area, button) {
  area.select();
  try {
    await navigator.clipboard.writeText(area.value);
  } catch {
    document.execCommand('copy'); // where the browser keeps the clipboard from pages in files
  }
  button.textContent = 'Copied';
  setTimeout(() => {
    button.textContent = 'Copy';
  }, 1500);
}

function entry(kind, title, text) {
  const area = element('textarea', {
    readOnly: true,
    value: text,
    rows: Math.min(6, 1 + Math.floor(text.length / 90)),
    'aria-label': title,
  });
  const button = element('button', { type: 'button', textContent: 'Copy', onclick: () => copy(area, button) });
  return element(
    'div',
    { class: 'entry', 'data-kind': kind },
    element('div', { class: 'row' }, element('span', { textContent: title }), button),
    area,
  );
}

/** @param {import('../dataset.js').Dataset} dataset @param {number} row */
export function openCopyDialog(dataset, row) {
  const set = setCommand(dataset, row);
  const dialog = element(
    'dialog',
    { class: 'copy', 'aria-label': 'Variant as a model', onclose: () => dialog.remove() },
    element('h2', { textContent: `Variant ${dataset.ids[row]} as a model` }),
    entry('model', 'Written from the store, exactly', modelCommand(dataset, row)),
    ...(set ? [entry('set', 'Set on the model that the study starts from', set)] : []),
    entry(
      'list',
      'Its variables and metrics, a table for spreadsheets and for studies (sampler "list")',
      listTable(dataset, row),
    ),
    element(
      'div',
      { class: 'row end' },
      element('button', { type: 'button', textContent: 'Close', onclick: () => dialog.close() }),
    ),
  );
  document.body.append(dialog);
  dialog.showModal();
}
