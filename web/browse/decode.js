// Data blocks of the page: base64 in <script> elements, little-endian.

/**
 * The bytes of a block, which is then emptied, to free its memory.
 * @param {string} id
 */
export function takeBytes(id) {
  const block = document.getElementById(id);
  const text = block.textContent;
  block.textContent = '';
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text),
    bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; ++k) bytes[k] = letters.charCodeAt(k);
  return bytes;
}

/** A block as numbers of a kind, such as Float64Array. */
export function takeNumbers(id, Kind) {
  return new Kind(takeBytes(id).buffer);
}

/** A block of JSON. */
export function readJson(id) {
  return JSON.parse(document.getElementById(id).textContent);
}
