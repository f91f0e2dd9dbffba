'use strict';
// What the report does beyond showing: pictures under a slider, filters, long tables cut short.
// Everything can be read without it.
(() => {
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];

  function element(name, properties, parent) {
    const made = Object.assign(document.createElement(name), properties);
    parent.append(made);
    return made;
  }

  // One button per choice; `choose` gets its index.
  function tabs(buttons, choose, first = 0) {
    const press = (index) => {
      buttons.forEach((button, k) => button.setAttribute('aria-pressed', k === index));
      choose(index);
    };
    buttons.forEach((button, k) => button.addEventListener('click', () => press(k)));
    press(first);
  }

  function slider(stage, setCut) {
    const input = element('input', { type: 'range', min: 0, max: 100, value: 50 }, stage);
    input.setAttribute('aria-label', 'Part of the picture that shows the body before');
    element('div', { className: 'divider' }, stage);
    const follow = (event) => {
      const box = stage.getBoundingClientRect();
      setCut(100 * Math.min(1, Math.max(0, (event.clientX - box.left) / box.width)));
    };
    stage.addEventListener('pointerdown', (event) => {
      stage.setPointerCapture(event.pointerId);
      follow(event);
    });
    stage.addEventListener('pointermove', (event) => {
      if (event.buttons & 1) follow(event);
    });
    input.addEventListener('input', () => setCut(Number(input.value)));
    return input;
  }

  function pictures(section) {
    const figures = all('.compare', section);
    const inputs = [];
    const setCut = (percent) => {
      section.style.setProperty('--cut', `${percent}%`);
      inputs.forEach((input) => { input.value = percent; });
    };
    all('.stage', section).forEach((stage) => inputs.push(slider(stage, setCut)));
    const bar = element('div', { className: 'tabs' }, section);
    section.insertBefore(bar, figures[0]);
    const buttons = figures.map(
      (figure) => element('button', { textContent: figure.dataset.label }, bar));
    tabs(buttons, (index) => {
      figures.forEach((figure, k) => figure.classList.toggle('current', k === index));
    });
    setCut(50);
  }

  // Coming closer to a drawing that has a viewBox.
  function zoomable(svg) {
    const box = svg.viewBox.baseVal, home = [box.x, box.y, box.width, box.height];
    const set = (x, y, w, h) => { [box.x, box.y, box.width, box.height] = [x, y, w, h]; };
    const place = (event) => new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    svg.addEventListener('wheel', (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      const at = place(event);
      const factor = Math.min(home[2] / box.width, Math.max(0.01, Math.exp(0.004 * event.deltaY)));
      set(at.x + factor * (box.x - at.x), at.y + factor * (box.y - at.y), factor * box.width, factor * box.height);
    }, { passive: false });
    svg.addEventListener('pointerdown', (event) => svg.setPointerCapture(event.pointerId));
    svg.addEventListener('pointermove', (event) => {
      if (!(event.buttons & 1)) return;
      const scale = svg.getScreenCTM().a;
      set(box.x - event.movementX / scale, box.y - event.movementY / scale, box.width, box.height);
    });
    svg.addEventListener('dblclick', () => set(...home));
  }

  function variables(section) {
    const groups = all('.group', section);
    const shown = 8;
    groups.forEach((group) => {
      const count = all('tbody tr', group).length;
      if (count <= shown) return;
      const button = element('button', { className: 'more', textContent: `Show all ${count}` }, group);
      button.addEventListener('click', () => {
        group.classList.add('all');
        button.remove();
      });
    });
    const text = section.querySelector('#filter');
    const atBound = section.querySelector('#at-bound');
    const update = () => {
      const wanted = text.value.trim().toLowerCase();
      const filtering = wanted !== '' || atBound.checked;
      let found = 0;
      groups.forEach((group) => {
        const rows = all('tbody tr', group);
        rows.forEach((row) => {
          const named = row.cells[0].textContent.toLowerCase().includes(wanted);
          row.hidden = !(named && (!atBound.checked || row.classList.contains('at-bound')));
        });
        const left = rows.filter((row) => !row.hidden).length;
        found += left;
        group.hidden = left === 0;
        const more = group.querySelector('.more');
        if (more) {
          more.hidden = filtering;
          group.classList.toggle('all', filtering);
        }
      });
      section.querySelector('#filter-count').textContent = filtering ? `${found} found` : '';
    };
    text.addEventListener('input', update);
    atBound.addEventListener('change', update);
  }

  document.documentElement.classList.add('live');
  window.reportTabs = tabs;
  all('.gallery').forEach(pictures);
  all('#variables').forEach(variables);
  all('.section').forEach(zoomable);
})();
