// Small helpers for elements of the page.

/**
 * An element with properties and children. `class`, `role`, `aria-...`, `data-...` and `for` are
 * attributes, the rest properties; `on...` are listeners.
 * @param {string} tag
 * @param {Record<string, any>} [properties]
 * @param {...(Node | string)} children
 */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
    else if (/^(class|role|for|aria-.*|data-.*)$/.test(key)) made.setAttribute(key, value);
    else made[key] = value;
  }
  made.append(...children);
  return made;
}

/** A list of choices: [value, label] each. */
export function choices(label, entries, value, choose) {
  const select = element('select', { 'aria-label': label, onchange: () => choose(select.value) });
  entries.forEach(([key, text]) => select.append(element('option', { value: key, textContent: text })));
  select.value = value;
  return select;
}

/** Buttons of which one is pressed: [value, label] each. */
export function tabs(label, entries, value, choose) {
  const group = element('div', { class: 'tabs', role: 'group', 'aria-label': label });
  const press = (key) => {
    [...group.children].forEach((button) => button.setAttribute('aria-pressed', String(button.dataset.key === key)));
  };
  entries.forEach(([key, text]) =>
    group.append(
      element('button', {
        type: 'button',
        textContent: text,
        'data-key': key,
        onclick: () => {
          press(key);
          choose(key);
        },
      }),
    ),
  );
  press(value);
  return group;
}

/** A box to tick. */
export function tick(label, checked, choose) {
  const input = element('input', { type: 'checkbox', checked, onchange: () => choose(input.checked) });
  return element('label', { class: 'tick' }, input, label);
}

/** A name that lines may break after its dots and underscores: the children of an element. */
export function breakable(name) {
  return name.split(/(?<=[._])/).flatMap((part, k) => (k === 0 ? [part] : [element('wbr'), part]));
}
