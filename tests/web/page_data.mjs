// The data in the text of a page, decoded without the code of the page.

/** The content of a <script> element. */
export function blockText(html, id) {
  const start = html.indexOf(`id="${id}">`);
  if (start < 0) throw new Error(`the page has no block ${id}`);
  const from = start + `id="${id}">`.length;
  return html.slice(from, html.indexOf('</script>', from));
}

/** A block of numbers of a kind, such as Float64Array. */
export function blockNumbers(html, id, Kind) {
  const bytes = Buffer.from(blockText(html, id), 'base64');
  return new Kind(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
}

/** What the page knows beside its numbers. */
export const description = (html) => JSON.parse(blockText(html, 'description'));
