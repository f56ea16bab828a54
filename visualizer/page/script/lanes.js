// Inside intervals of the current ray: a lane for each node, and a line that sweeps over them.
const lanes = (() => {
  const box = element('lanes-drawing');
  const colours = ['#4a5568', '#2b7bba', '#c2570c', '#7a5195', '#2a8c6a', '#9c6f00'];
  const rowHeight = 20, labelWidth = 150, countWidth = 34;
  let range = null, sweep = null, of = -1;

  const lanesOf = ray => {
    const found = [], events = rays[ray].events;
    for (let i = 0; i < events.length; ++i) {
      if (events[i].event !== 'node_evaluated') continue;
      const spans = [];
      for (let k = 1; k <= events[i].count; ++k) spans.push([number(events[i + k].enter.t), number(events[i + k].exit.t)]);
      const nodes = trace.objects[events[i].object].nodes.length, root = events[i].node + 1 === nodes;
      found.push({ name: nodeName(events[i]), root, spans, first: found.length - events[i].node });
    }
    // The root of a compound stands above its parts.
    const ordered = [];
    for (let i = 0; i < found.length;) {
      let last = i;
      while (last + 1 < found.length && !found[last].root) ++last;
      ordered.push(found[last], ...found.slice(i, last));
      i = last + 1;
    }
    return ordered;
  };

  const stopOf = ray => {
    const hit = find(ray, 'boundary_chosen');
    if (hit) return number(hit.boundary.t);
    const blocker = start(ray).kind === 'shadow' && find(ray, 'ray_finished')?.colour.every(c => c === 0) ? blockerOf(ray) : null;
    return blocker ? number(blocker.t) : number(start(ray).reach);
  };

  const wholeRange = (list, stop) => {
    const times = list.flatMap(lane => lane.spans.flat()).filter(t => t > 0 && Number.isFinite(t));
    if (Number.isFinite(stop) && stop > 0) times.push(stop);
    if (times.length === 0) return [-0.05, 1];
    const near = Number.isFinite(stop) && stop > 0 ? stop : Math.min(...times);
    const high = Math.max(...times.filter(t => t <= 8 * near), near);
    return [-0.04 * high, 1.1 * high];
  };

  const paint = () => {
    const ray = walk.ray, list = lanesOf(ray), stop = stopOf(ray);
    if (of !== ray) { range = null; sweep = null; of = ray; }
    element('lanes-title').textContent = `Inside intervals along ray ${ray}`;
    if (list.length === 0) { box.replaceChildren(make('p', {}, 'The ray’s line meets no object.')); return; }
    const [low, high] = range ?? wholeRange(list, stop);
    const width = Math.max(360, box.clientWidth || 800), right = width - countWidth, top = 22;
    const height = top + list.length * rowHeight + 24;
    const at = t => labelWidth + (Math.min(Math.max(t, low), high) - low) / (high - low) * (right - labelWidth);
    const svg = draw('svg', { viewBox: `0 0 ${width} ${height}`, height, role: 'img', 'aria-label': 'Inside intervals: ' + list.map(lane =>
      lane.name + ' ' + (lane.spans.length === 0 ? 'never' : lane.spans.map(([a, b]) => shown(a) + ' to ' + shown(b)).join(', '))).join('; ') });
    const line = (x, colour, extra = {}) => svg.append(draw('line', { x1: x, x2: x, y1: top - 4, y2: height - 20, stroke: colour, ...extra }));
    const step = 10 ** Math.floor(Math.log10((high - low) / 4)), stride = step * ((high - low) / step > 20 ? 5 : (high - low) / step > 9 ? 2 : 1);
    for (let k = Math.ceil(low / stride); k * stride <= high; ++k) {
      line(at(k * stride), '#e3e7ec');
      svg.append(draw('text', { x: at(k * stride), y: height - 6, 'text-anchor': 'middle', class: 'quiet' }, shown(k * stride, 4)));
    }
    list.forEach((lane, i) => {
      const y = top + i * rowHeight, colour = lane.root ? '#20242a' : colours[i % colours.length];
      const label = draw('text', { x: lane.root ? 0 : 12, y: y + 14, class: lane.root ? 'root' : '' }, lane.name.length > 21 ? lane.name.slice(0, 20) + '…' : lane.name);
      label.append(draw('title', {}, lane.name));
      svg.append(label, draw('line', { x1: labelWidth, x2: right, y1: y + 10, y2: y + 10, stroke: '#d5dae0' }));
      for (const [a, b] of lane.spans) {
        if (b < low || a > high) continue;
        const bar = draw('rect', { x: at(a), y: y + 3, width: Math.max(at(b) - at(a), 1.5), height: rowHeight - 7, fill: colour, opacity: b <= 0 ? 0.35 : 0.9, rx: 2 });
        bar.append(draw('title', {}, `${lane.name}: inside ${shown(a)} < t < ${shown(b)}`));
        svg.append(bar);
      }
      if (sweep !== null) {
        const inside = lane.spans.some(([a, b]) => a < sweep && sweep < b);
        svg.append(draw('text', { x: width - 2, y: y + 14, 'text-anchor': 'end', class: inside ? 'root' : 'quiet', 'data-inside': inside }, inside ? 'in' : 'out'));
      }
    });
    line(at(0), '#5b6470');
    if (Number.isFinite(stop) && stop >= low && stop <= high) {
      line(at(stop), '#b34700', { 'stroke-width': 2 });
      const hit = find(ray, 'boundary_chosen');
      svg.append(draw('text', { x: Math.min(at(stop), right - 60), y: 12, 'text-anchor': 'middle', class: 'root' }, `${hit ? 'hit' : 'end'} t = ${shown(stop)}`));
    }
    if (sweep !== null) {
      line(at(sweep), '#0b57d0', { 'stroke-width': 1.5, 'stroke-dasharray': '4 3' });
      svg.append(draw('text', { x: 0, y: 12, 'data-sweep': sweep }, `t = ${shown(sweep)}`));
    }
    const timeAt = event => {
      const area = svg.getBoundingClientRect();
      return low + ((event.clientX - area.left) * width / area.width - labelWidth) / (right - labelWidth) * (high - low);
    };
    svg.addEventListener('pointermove', event => {
      const t = timeAt(event);
      sweep = t >= low && t <= high ? t : null;
      paint();
    });
    svg.addEventListener('pointerleave', () => { sweep = null; paint(); });
    svg.addEventListener('wheel', event => {
      event.preventDefault();
      const t = timeAt(event), factor = Math.exp(event.deltaY * 0.002);
      range = [t - (t - low) * factor, t + (high - t) * factor];
      if (range[1] - range[0] > 1e-12 * Math.max(1, Math.abs(t))) paint(); else range = [low, high];
    }, { passive: false });
    svg.addEventListener('dblclick', () => { range = null; paint(); });
    box.replaceChildren(svg);
  };
  addEventListener('resize', paint);
  return { show: paint };
})();
