// Numbers as text.

const minus = '\u2212';

/** All digits of a number, enough to read it back; a dash where there is none. */
export function exact(value) {
  return Number.isFinite(value) ? String(value) : '–';
}

/** A number for reading, with so many significant digits. */
export function short(value, digits = 5) {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  const text =
    size !== 0 && (size < 1e-3 || size >= 1e7)
      ? value.toExponential(digits - 1).replace(/\.?0+e/, 'e')
      : String(Number(value.toPrecision(Math.max(digits, size >= 1 ? Math.floor(Math.log10(size)) + 1 : 0))));
  return text.replace(/^-/, minus);
}

/** A whole number with spaces between groups of three digits. */
export function counted(count) {
  return String(count).replace(/\B(?=(\d{3})+$)/g, '\u202f');
}

/** A column's name with its unit. */
export function titled(column) {
  return column.unit && column.unit !== '1' ? `${column.name} (${column.unit})` : column.name;
}
