// The trace as the program recorded it, and what is drawn around it.
const trace = JSON.parse(document.getElementById('trace').textContent);
const scene = JSON.parse(document.getElementById('scene').textContent);
const rays = trace.rays;
const element = id => document.getElementById(id);

// Infinities stand as texts in JSON.
const number = value => value === 'inf' ? Infinity : value === '-inf' ? -Infinity : value === 'nan' ? NaN : value;
const shown = (value, digits = 6) => {
  const x = number(value);
  if (typeof x !== 'number') return String(x);
  if (!Number.isFinite(x)) return Number.isNaN(x) ? 'none' : x > 0 ? '∞' : '−∞';
  if (x === 0) return '0';
  const text = Math.abs(x) >= 1e6 || Math.abs(x) < 1e-4 ? x.toExponential(digits - 1) : x.toPrecision(digits);
  return text.replace(/(\.\d*?)0+(e|$)/, '$1$2').replace(/\.(e|$)/, '$1').replace('-', '−');
};
const shownVector = v => '(' + v.map(c => shown(c)).join(', ') + ')';
const shownColour = c => c[0] === c[1] && c[1] === c[2] ? shown(c[0]) : shownVector(c);
const degrees = (radians, digits = 5) => shown(number(radians) * 180 / Math.PI, digits) + '°';

const start = ray => rays[ray].events[0];
const find = (ray, name) => rays[ray].events.find(event => event.event === name);
const weight = ray => Math.max(...start(ray).weight.map(number));

// Text only, whatever a scene calls its things.
const make = (tag, attributes = {}, ...children) => {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
};
const draw = (tag, attributes = {}, text) => {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  if (text !== undefined) made.textContent = text;
  return made;
};
const row = (name, ...values) => make('tr', {}, make('th', { scope: 'row' }, name), make('td', {}, ...values));
