// Buttons, keys, slider, play; and what follows each step.
(() => {
  const slider = element('slider'), play = element('play');
  const source = trace.source, name = source.scene.split('/').pop();
  element('title').textContent = source.by_hand ? `${name}, a ray given by hand` : `${name}, pixel (${source.x}, ${source.y})${source.sample > 0 ? `, sample ${source.sample}` : ''}`;
  element('title').title = source.scene;
  document.title = element('title').textContent + ' · rayscope';
  slider.max = inTime.length - 1;

  let timer = 0;
  const stop = () => { clearInterval(timer); timer = 0; play.textContent = '▶'; play.setAttribute('aria-pressed', 'false'); play.setAttribute('aria-label', 'play'); };
  const run = () => {
    stop();
    if (walk.ray === inTime.at(-1)) walk.go(0);
    timer = setInterval(() => { if (!walk.next()) stop(); }, 900 / Number(element('speed').value));
    play.textContent = '❚❚';
    play.setAttribute('aria-pressed', 'true');
    play.setAttribute('aria-label', 'pause');
  };
  const toggle = () => timer ? stop() : run();
  element('speed').addEventListener('change', () => { if (timer) run(); });

  const actions = {
    first: () => walk.go(0), last: () => walk.goTo(inTime.at(-1)), next: () => walk.next(), back: () => walk.back(), play: toggle,
    keys: () => element('help').showModal(),
  };
  for (const [id, action] of Object.entries(actions)) element(id).addEventListener('click', action);
  slider.addEventListener('input', () => walk.goTo(inTime[slider.value]));
  for (const button of document.querySelectorAll('[data-camera]'))
    button.addEventListener('click', () => { view.cameras[button.dataset.camera](); view.changed(); });

  const keys = [
    [['ArrowRight', 'n'], 'next ray', actions.next], [['ArrowLeft', 'b'], 'previous ray', actions.back],
    [['ArrowDown', 'i'], 'into the ray that this one spawns', () => walk.in()], [['ArrowUp', 'u'], 'out, to its parent', () => walk.out()],
    [['o'], 'over what this ray spawns', () => walk.over()], [['s', '.'], 'next event', () => walk.step()], [['S', ','], 'previous event', () => walk.stepBack()],
    [[' '], 'play and pause', toggle], [['Home'], 'to the start', actions.first], [['End'], 'to the end', actions.last],
    [['f'], 'see everything', () => { view.cameras.fit(); view.changed(); }], [['e'], 'see it from the eye', () => { view.cameras.eye(); view.changed(); }],
    [['a'], 'look along the ray', () => { view.cameras.along(); view.changed(); }], [['?'], 'this list', actions.keys],
  ];
  const shownKey = { ArrowRight: '→', ArrowLeft: '←', ArrowDown: '↓', ArrowUp: '↑', ' ': 'space' };
  element('help').querySelector('table').append(...keys.map(([names, help]) =>
    make('tr', {}, make('td', {}, ...names.flatMap(key => [make('kbd', {}, shownKey[key] ?? key), ' '])), make('td', {}, help))));
  addEventListener('keydown', event => {
    if (event.ctrlKey || event.altKey || event.metaKey || element('help').open) return;
    const typing = event.target.matches('select, input'), pressing = event.target.matches('button, summary');
    if (typing || (pressing && event.key === ' ')) return;
    const found = keys.find(([names]) => names.includes(event.key));
    if (!found) return;
    event.preventDefault();
    if (found[2] !== toggle && timer) stop();
    found[2]();
  });

  element('legend').append(...[['eye', '#20242a'], ['reflected', '#0072b2'], ['refracted', '#d55e00'], ['shadow', '#e69f00', '5 4']].map(([kind, colour, dash]) => {
    const svg = draw('svg', { width: 26, height: 8, 'aria-hidden': true });
    svg.append(draw('line', { x1: 0, x2: 26, y1: 4, y2: 4, stroke: colour, 'stroke-width': 3, 'stroke-dasharray': dash ?? 'none' }));
    return make('li', {}, svg, kind);
  }));

  const show = () => {
    const { ray, event } = walk.spot;
    slider.value = placeInTime.get(ray);
    slider.setAttribute('aria-valuetext', `ray ${ray}, ${start(ray).kind}`);
    element('where').textContent = `ray ${ray} of ${rays.length - 1}` + (event > 0 ? `, event ${event}` : '');
    writeAddress();
    tree.show();
    lanes.show();
    card.show();
    details.show();
    view.show();
  };
  tree.fill();
  addEventListener('hashchange', readAddress);
  walk.listeners.push(show);
  if (!readAddress()) show();
  element('least').addEventListener('input', view.changed);
  window.rayscope = { state: () => walk.state(), go: (ray, event = 0) => walk.goTo(ray, event), camera: view.camera };
})();
