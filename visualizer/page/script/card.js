// Both sides of a boundary that lets light through.
const card = (() => {
  const show = () => {
    const numbers = scene.cards[walk.ray];
    element('card').hidden = numbers === null;
    if (numbers === null) return;
    const total = numbers.theta_to === null;
    element('card-title').textContent = total ? 'Total internal reflection' : 'Refraction';
    const svg = draw('svg', { viewBox: '0 0 360 190', role: 'img', 'aria-label': `Angles at the boundary: ${degrees(numbers.theta_from)} before, ${total ? 'none' : degrees(numbers.theta_to)} behind` });
    const length = 82, middle = [180, 95];
    const tip = (angle, up) => [middle[0] + length * Math.sin(angle), middle[1] + (up ? -1 : 1) * length * Math.cos(angle)];
    const line = (from, to, colour, extra = {}) => svg.append(draw('line', { x1: from[0], y1: from[1], x2: to[0], y2: to[1], stroke: colour, 'stroke-width': 3, ...extra }));
    const arc = (angle, up, radius) => {
      const to = [middle[0] + radius * Math.sin(angle), middle[1] + (up ? -1 : 1) * radius * Math.cos(angle)];
      svg.append(draw('path', { d: `M ${middle[0]} ${middle[1] + (up ? -radius : radius)} A ${radius} ${radius} 0 0 ${(angle > 0) === up ? 1 : 0} ${to[0]} ${to[1]}`, fill: 'none', stroke: '#5b6470' }));
    };
    svg.append(draw('rect', { x: 0, y: 95, width: 360, height: 95, fill: numbers.speed_to < numbers.speed_from ? '#d8e8f5' : '#f3f6f9' }),
      draw('rect', { x: 0, y: 0, width: 360, height: 95, fill: numbers.speed_to < numbers.speed_from ? '#f3f6f9' : '#d8e8f5' }));
    line([0, 95], [360, 95], '#5b6470', { 'stroke-width': 1.5 });
    line([180, 8], [180, 182], '#9aa4b0', { 'stroke-width': 1, 'stroke-dasharray': '5 4' });
    if (numbers.critical !== null) line(middle, tip(-numbers.critical, true), '#8b2f6b', { 'stroke-width': 1.2, 'stroke-dasharray': '2 3' });
    line(tip(-numbers.theta_from, true), middle, '#20242a');
    if (total || numbers.reflection > 0) line(middle, tip(numbers.theta_from, true), '#0068a5', total ? {} : { 'stroke-width': 1.8 });
    if (!total) line(middle, tip(numbers.theta_to, false), '#b34700');
    arc(-numbers.theta_from, true, 34);
    if (!total) arc(numbers.theta_to, false, 34);
    const text = (x, y, words, anchor = 'start') => svg.append(draw('text', { x, y, 'text-anchor': anchor }, words));
    text(6, 16, mediumName(numbers.from));
    text(6, 182, mediumName(numbers.to));
    text(354, 16, 'θ₁ = ' + degrees(numbers.theta_from), 'end');
    text(354, 182, total ? 'no ray goes there' : 'θ₂ = ' + degrees(numbers.theta_to), 'end');
    element('card-drawing').replaceChildren(svg);
    const percent = share => shown(100 * share, 4) + ' %';
    const beyond = numbers.critical === null ? null : numbers.theta_from - numbers.critical;
    element('card-numbers').replaceChildren(
      row('speeds', `c₁ = ${shown(numbers.speed_from)}, c₂ = ${shown(numbers.speed_to)}`),
      row('indices', `n₁ = ${shown(1 / numbers.speed_from)}, n₂ = ${shown(1 / numbers.speed_to)}`),
      row('Snell', `sin θ₂ = ${shown(numbers.eta)} × ${shown(Math.sin(numbers.theta_from))} = ${shown(numbers.eta * Math.sin(numbers.theta_from))}${total ? ' > 1' : ''}`),
      row('critical', beyond === null ? 'none: not into a faster medium' : `${degrees(numbers.critical)}; θ₁ is ${degrees(Math.abs(beyond))} ${beyond > 0 ? 'beyond' : 'below'} it`),
      row('bends', total ? 'not at all: all is mirrored' : numbers.eta === 1 ? 'not at all' : numbers.eta < 1 ? 'towards the normal' : 'away from the normal'),
      row('Fresnel', `R = ${percent(numbers.fresnel)}, T = ${percent(1 - numbers.fresnel)}; Schlick R ≈ ${percent(numbers.schlick)}`),
      row('material', total ? `reflection + transmission = ${shown(numbers.reflection)}, all mirrored`
        : `reflection ${shown(numbers.reflection)}, transmission ${shown(numbers.transmission)}`));
  };
  return { show };
})();
