// A variant as text for other tools.
import { csvOf } from '../table/csv.js';
import { exact } from '../format.js';

const quoted = (word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

/** The command that writes a variant as a model. */
export function modelCommand(dataset, row) {
  const { about } = dataset,
    id = dataset.ids[row];
  return ['bodyline', 'space', about.store, 'model', String(id), '-o', `${about.study}-${id}.toml`]
    .map(quoted)
    .join(' ');
}

/**
 * The command that sets all variables on the study's model; null where variants have several, or
 * where a variable is no number of the model itself.
 */
export function setCommand(dataset, row) {
  const { about, columns } = dataset,
    variables = dataset.variableColumns();
  if (about.base !== 'model' || variables.some((k) => columns[k].kind !== 'value')) return null;
  const numbers = variables.map((k) => `${columns[k].name}=${exact(dataset.values(k)[row])}`);
  const id = dataset.ids[row];
  return ['bodyline', 'set', about.models[0], ...numbers, '-o', `${about.study}-${id}.toml`].map(quoted).join(' ');
}

/** A table of one row, which a study reads with sampler kind "list". */
export const listTable = (dataset, row) => csvOf(dataset, [row]);
