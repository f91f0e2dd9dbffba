// Rows as CSV, as `bodyline space STORE table` writes them.
import { exact } from '../format.js';

const field = (value) => (Number.isFinite(value) ? exact(value) : '');
const quoted = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

/**
 * @param {import('../dataset.js').Dataset} dataset
 * @param {Iterable<number>} rows
 */
export function csvOf(dataset, rows) {
  const { columns, about } = dataset;
  const heads = columns.map((column) => (column.metric ? 'out:' : 'in:') + column.name);
  const lines = [['id', ...heads, 'status', 'cause'].map(quoted).join(',')];
  const values = columns.map((_, k) => dataset.values(k));
  for (const row of rows) {
    lines.push(
      [
        dataset.ids[row],
        ...values.map((column) => field(column[row])),
        about.statuses[dataset.status[row]],
        quoted(about.causes[dataset.cause[row]]),
      ].join(','),
    );
  }
  return `${lines.join('\n')}\n`;
}

/** Lets the browser save a text as a file. */
export function save(name, text, kind) {
  const url = URL.createObjectURL(new Blob([text], { type: kind }));
  const link = Object.assign(document.createElement('a'), { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}
