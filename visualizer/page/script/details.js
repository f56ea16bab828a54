// The numbers of the current ray, and its events.
const details = (() => {
  const value = content => Array.isArray(content) ? shownVector(content) : content !== null && typeof content === 'object'
    ? Object.entries(content).map(([name, part]) => `${name} ${value(part)}`).join(', ') : shown(content);

  // Every member as the trace has it; the full digits stand in the title.
  const fields = event => {
    const table = make('table', { class: 'fields' });
    for (const [name, content] of Object.entries(event)) {
      if (name === 'event') continue;
      const cell = row(name, value(content));
      cell.lastChild.title = JSON.stringify(content);
      table.append(cell);
    }
    return table;
  };

  const rayLink = ray => {
    const button = make('button', { class: 'local', 'data-go': ray }, 'ray ' + ray);
    return button;
  };

  const numbers = ray => {
    const begun = start(ray), hit = find(ray, 'boundary_chosen'), end = find(ray, 'ray_finished'), table = make('table');
    if (rays[ray].parent >= 0) table.append(row('spawned by', rayLink(rays[ray].parent)));
    table.append(row('depth, weight', `${begun.depth} of ${trace.max_depth}, ${shownColour(begun.weight)}`),
      row('origin', shownVector(begun.origin)), row('direction', shownVector(begun.direction)), row('medium', mediumName(begun.medium)));
    if (begun.wavelength > 0) table.append(row('wavelength', `${shown(begun.wavelength)} nm`));
    if (begun.light >= 0) table.append(row('light', lightName(begun.light)));
    if (hit) {
      const leaf = leafName(hit.boundary.leaf), object = objectName(hit.object);
      table.append(row('hit', `${hit.entering ? 'into' : 'out of'} ${object}${leaf === object ? '' : ' through ' + leaf}`),
        row('t', `${shown(hit.boundary.t)} ± ${shown(hit.error_bound, 3)}`), row('point', shownVector(hit.point)), row('normal', shownVector(hit.facing)));
    }
    for (const event of rays[ray].events) {
      if (event.event === 'absorbed') table.append(row('absorbed', `${mediumName(event.medium)} leaves ${shownColour(event.passed)} on ${shown(event.length)} of way`));
      if (event.event === 'fresnel_shared') table.append(row('Fresnel', `R = ${shown(event.reflected)} (Rs ${shown(event.perpendicular)}, Rp ${shown(event.parallel)}; Schlick ${shown(event.schlick)})${line(event)}`));
      if (event.event === 'ambient_lit') table.append(row('ambient', `${shownColour(event.scene)} × ${shownColour(event.material)}`));
      if (event.event === 'light_lit')
        table.append(row('light ' + lightName(event.light), number(event.cosine) > 0
          ? `n·l = ${shown(event.cosine)}, visibility ${shownColour(event.visibility)}: diffuse ${shownColour(event.diffuse)}, specular ${shownColour(event.specular)}`
          : `n·l = ${shown(event.cosine)}: behind the surface`));
      if (event.event === 'not_spawned' && event.reason !== 'coefficient_zero')
        table.append(row('not followed', `${event.kind}: ${event.reason.replaceAll('_', ' ')}, weight ${shownColour(event.weight)}`));
    }
    if (rays[ray].children.length > 0)
      table.append(row('spawns', ...rays[ray].children.flatMap((child, i) => i > 0 ? [', ', rayLink(child)] : [rayLink(child)])));
    if (end) table.append(row('brings back', `${shownColour(end.colour)}, of which local ${shownColour(end.local)}`));
    return table;
  };

  const show = () => {
    const ray = walk.ray, kind = start(ray).kind;
    element('details-title').textContent = `Ray ${ray}, ${kind}`;
    element('details-title').className = kind;
    element('details-numbers').replaceChildren(numbers(ray));
    const most = 400, all = rays[ray].events, first = Math.max(0, Math.min(walk.spot.event - most / 2, all.length - most));
    const list = element('events');
    list.start = first;
    list.replaceChildren(...all.slice(first, first + most).map((event, i) => {
      const here = first + i === walk.spot.event;
      const item = make('li', { 'data-event': first + i }, eventText(event));
      if (here) { item.setAttribute('aria-current', 'step'); item.append(fields(event)); }
      return item;
    }));
  };
  element('events').addEventListener('click', event => {
    const clicked = event.target.closest('[data-event]');
    if (clicked) walk.goTo(walk.ray, Number(clicked.dataset.event));
  });
  element('details').addEventListener('click', event => {
    if (event.target.dataset.go !== undefined) walk.goTo(Number(event.target.dataset.go));
  });
  return { show };
})();
