// The recursion as a list of rows, of which only those in sight exist.
const tree = (() => {
  const box = element('tree'), inner = element('tree-height'), least = element('least');
  const rowHeight = 22;
  const lightest = Math.min(...rays.map((_, ray) => weight(ray)).filter(w => w > 0), 1);
  let rows = [], lineOf = new Map();

  // The slider is logarithmic, from all rays to the eye's alone.
  const leastWeight = () => least.value === '0' ? 0 : lightest ** (1 - least.value / 100) * 1.0000001;

  const fill = () => {
    const limit = leastWeight();
    rows = [];
    const open = [[0, 0]];
    while (open.length > 0) {
      const [ray, level] = open.pop();
      if (weight(ray) < limit && ray !== walk.ray) continue;
      rows.push({ ray, level });
      for (const child of rays[ray].children.toReversed()) open.push([child, level + 1]);
    }
    lineOf = new Map(rows.map((row, line) => [row.ray, line]));
    inner.style.height = rows.length * rowHeight + 'px';
    element('recursion-title').textContent = `Recursion: ${rays.length} ray${rays.length === 1 ? '' : 's'}` +
      (rows.length < rays.length ? `, ${rows.length} shown` : '') + (trace.events_dropped > 0 ? ' (the record was full)' : '');
    element('least-shown').textContent = limit === 0 ? '0' : shown(limit, 2);
    paint();
  };

  const paint = () => {
    const printing = matchMedia('print').matches;
    const first = printing ? 0 : Math.max(0, Math.floor(box.scrollTop / rowHeight) - 4);
    const last = printing ? rows.length : Math.min(rows.length, first + Math.ceil((box.clientHeight || 400) / rowHeight) + 8);
    const made = [];
    for (let line = first; line < last; ++line) {
      const { ray, level } = rows[line], kind = start(ray).kind;
      const future = startOf(ray) > walk.moment ? ' future' : '';
      const share = make('span', { class: 'share' }, kind === 'shadow' ? '' : shown(weight(ray), 2));
      const made_row = make('div', { class: `row ${kind}${future}`, role: 'treeitem', id: 'row-' + ray, 'data-ray': ray, 'aria-level': level + 1,
        'aria-selected': ray === walk.ray, title: `${ray} ${kind}, depth ${start(ray).depth}, weight ${shown(weight(ray))}` },
        make('span', { class: 'name' }, `${ray} ${kind} ${becameOf(ray)}`), share);
      made_row.style.top = line * rowHeight + 'px';
      made_row.style.paddingLeft = 6 + Math.min(level, 10) * 12 + 'px';
      made.push(made_row);
    }
    inner.replaceChildren(...made);
    box.setAttribute('aria-activedescendant', 'row-' + walk.ray);
  };

  const show = () => {
    if (!lineOf.has(walk.ray)) fill();
    const top = lineOf.get(walk.ray) * rowHeight;
    if (top < box.scrollTop || top + rowHeight > box.scrollTop + box.clientHeight) box.scrollTop = top - box.clientHeight / 2;
    paint();
  };

  box.addEventListener('scroll', paint);
  box.addEventListener('click', event => {
    const clicked = event.target.closest('[data-ray]');
    if (clicked) walk.goTo(Number(clicked.dataset.ray));
  });
  box.addEventListener('keydown', event => {
    const line = lineOf.get(walk.ray), to = event.key === 'ArrowDown' ? line + 1 : event.key === 'ArrowUp' ? line - 1 : -1;
    if (event.key !== 'ArrowDown' && event.key !== 'ArrowUp') return;
    event.preventDefault();
    event.stopPropagation();
    if (rows[to]) walk.goTo(rows[to].ray);
  });
  least.addEventListener('input', fill);
  addEventListener('beforeprint', () => { inner.style.height = rows.length * rowHeight + 'px'; });
  matchMedia('print').addEventListener('change', paint);
  addEventListener('resize', paint);
  return { fill, show, isHidden: ray => !lineOf.has(ray) };
})();
