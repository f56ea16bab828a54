// Where one is: an event of a ray. Moments are events in the order in which they happened.
const moments = [];
for (let i = 0; i < scene.moments.length; i += 2) moments.push({ ray: scene.moments[i], event: scene.moments[i + 1] });
const momentOf = new Map(moments.map((spot, moment) => [spot.ray + '.' + spot.event, moment]));
const startOf = ray => momentOf.get(ray + '.0');
const inTime = moments.filter(spot => spot.event === 0).map(spot => spot.ray);
const placeInTime = new Map(inTime.map((ray, place) => [ray, place]));
const endOf = rays.map((ray, index) => momentOf.get(index + '.' + (ray.events.length - 1)));

const walk = {
  moment: 0,
  listeners: [],
  get spot() { return moments[this.moment]; },
  get ray() { return this.spot.ray; },
  get event() { return rays[this.ray].events[this.spot.event]; },
  go(moment) {
    if (!(moment >= 0 && moment < moments.length) || moment === this.moment) return false;
    this.moment = moment;
    for (const listener of this.listeners) listener();
    return true;
  },
  goTo(ray, event = 0) { return this.go(momentOf.get(ray + '.' + event) ?? -1); },
  step() { return this.go(this.moment + 1); },
  stepBack() { return this.go(this.moment - 1); },
  next() { const after = inTime.find(ray => startOf(ray) > this.moment); return after !== undefined && this.goTo(after); },
  back() { const before = inTime.findLast(ray => startOf(ray) < this.moment); return before !== undefined && this.goTo(before); },
  in() { const child = rays[this.ray].children.find(ray => startOf(ray) > this.moment); return child !== undefined && this.goTo(child); },
  over() {
    if (this.spot.event > 0) return this.spot.event + 1 < rays[this.ray].events.length ? this.goTo(this.ray, this.spot.event + 1) : this.out();
    const parent = rays[this.ray].parent;
    if (parent < 0) return false;
    const sibling = rays[parent].children.find(ray => startOf(ray) > this.moment);
    return sibling !== undefined ? this.goTo(sibling) : this.out();
  },
  out() {
    if (rays[this.ray].parent < 0) return false;
    const after = Math.min(endOf[this.ray] + 1, moments.length - 1);
    return this.go(after);
  },
  // What the terminal's JSON says of the same place.
  state() {
    const spot = this.spot, begun = start(spot.ray);
    return { ray: spot.ray, event: spot.event, events: rays[spot.ray].events.length, moment: this.moment, moments: moments.length,
      kind: begun.kind, depth: begun.depth, weight: begun.weight, what: this.event.event, data: this.event };
  },
};

const pathTo = ray => {
  const path = [];
  for (; ray >= 0; ray = rays[ray].parent) path.push(ray);
  return path.reverse();
};

// The address names the step.
const readAddress = () => {
  const found = /^#ray=(\d+)(?:\.(\d+))?$/.exec(location.hash);
  return found !== null && walk.goTo(Number(found[1]), Number(found[2] ?? 0));
};
const writeAddress = () => {
  const { ray, event } = walk.spot;
  history.replaceState(null, '', '#ray=' + ray + (event > 0 ? '.' + event : ''));
};
