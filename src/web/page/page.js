// The page's parts together: the view and its controls, the slider, the table.
'use strict';

const byId = (id) => document.getElementById(id);
const millimetres = (metres) => {
  const value = 1000 * metres;
  return `${value.toFixed(value >= 100 ? 0 : value >= 10 ? 1 : 2)} mm`;
};
const counted = (number, noun) => `${number.toLocaleString('en')} ${noun}${number === 1 ? '' : 's'}`;

/** Red, green and blue in [0, 1]; `turn`: the hue in [0, 1). */
function colorOf(turn, saturation, lightness) {
  return [0, 8, 4].map((n) => {
    const k = (n + 12 * turn) % 12;
    return lightness - saturation * Math.min(lightness, 1 - lightness) * Math.max(-1, Math.min(k - 3, 9 - k, 1));
  });
}

/** A CSS colour, as the page has it now: light or dark. */
function styleColor(name) {
  const digits = getComputedStyle(document.documentElement).getPropertyValue(name).trim().slice(1);
  return [0, 2, 4].map((i) => parseInt(digits.slice(i, i + 2), 16) / 255);
}

class Page {
  constructor(data) {
    this.data = data;
    this.camera = new Camera();
    this.model = 0;
    this.selected = null;  // an element of the model
    this.stage = byId('stage');
    this.view = this.makeView(byId('canvas'));
    byId('drawn-by').textContent = this.view.name;
    this.setUpSlider();
    this.tellThinned();
    for (const id of ['show-original', 'show-hulls', 'show-worst', 'show-regions', 'show-kept', 'show-scene']) {
      if (byId(id)) byId(id).addEventListener('change', () => this.showBodies());
    }
    byId('reset').addEventListener('click', () => this.select(null));
    byId('slider').addEventListener('input', () => this.showBodies());
    steer(this.camera, this.stage, (moving) => this.draw(moving));
    new ResizeObserver(() => this.draw()).observe(this.stage);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.showBodies());
    this.select(null);
  }

  makeView(canvas) {
    const three = typeof THREE !== 'undefined' && location.hash !== '#drawn' && hasWebGl();
    return three ? new ThreeView(canvas) : new CanvasView(canvas);
  }

  get elements() {
    return this.data.models[this.model].elements;
  }

  // The slider.

  setUpSlider() {
    this.steps = stepsOf(this.data.models[this.model], this.data);
    byId('slider').max = this.steps.length;
    byId('slider').value = 0;
    byId('slider').disabled = this.steps.length === 0;
  }

  /** [m] What the hulls shown may protrude; 0: the hulls as they were written. */
  get tolerance() {
    const step = Number(byId('slider').value);
    return step > 0 ? this.steps[step - 1] : 0;
  }

  cutOf(element) {
    return cutAt(this.data.meshes[element.mesh], this.tolerance);
  }

  tellCount() {
    const shown = this.selected ? [this.selected] : this.elements;
    let hulls = 0, primitives = 0, bound = 0;
    for (const element of shown) {
      const nodes = this.data.meshes[element.mesh].nodes, leaves = nodes.filter((node) => node.left < 0).length;
      for (const id of this.cutOf(element)) {
        if (id < leaves && id >= leaves - element.primitives) ++primitives;
        else ++hulls;
        bound = Math.max(bound, nodes[id].bound);
      }
    }
    const what = this.selected && this.elements.length > 1 ? ` of ${this.selected.link}` : '';
    const bodies = [hulls > 0 && counted(hulls, 'hull'), primitives > 0 && counted(primitives, 'primitive')].filter(Boolean).join(' and ');
    byId('count').textContent = bodies ? `${bodies}${what}, protrusion at most ${millimetres(bound)}` : `no hulls${what}`;
    byId('count').dataset.hulls = hulls + primitives;
    const regions = this.elements.some((element) => element.regions.length > 0) ? ', ignoring regions' : '';
    const how = shown.every((element) => this.data.meshes[element.mesh].cuts) ? 'a cut of the hull tree' : 'merged for this page';
    byId('merged').textContent = this.tolerance > 0 ? `${how}${regions}` : 'as written';
  }

  tellThinned() {
    const meshes = this.data.meshes.filter((mesh) => mesh.original.triangles < 0.99 * mesh.triangles);
    if (meshes.length === 0) return;
    const sum = (of) => meshes.reduce((total, mesh) => total + of(mesh), 0).toLocaleString('en');
    byId('thinned').textContent = `Large meshes are thinned for this page: ${sum((mesh) => mesh.original.triangles)} of ` +
      `${sum((mesh) => mesh.triangles)} triangles are drawn. Hulls and numbers are exact.`;
  }

  // The view.

  checked(id) {
    return Boolean(byId(id) && byId(id).checked);
  }

  bodiesOf(element, index) {
    const mesh = this.data.meshes[element.mesh], bodies = [], faded = this.selected && element !== this.selected;
    const hulls = this.checked('show-hulls'), original = this.checked('show-original');
    if (original && !faded && mesh.original.triangles > 0) {
      const color = element.status === 'failed' ? styleColor('--failed') : styleColor('--mesh');
      bodies.push({triangles: trianglesOf(mesh.original, this.data), pose: element.pose, color, opacity: 1, hull: false});
    }
    if (this.checked('show-regions') && !faded) {
      for (const region of element.regions) {
        bodies.push({triangles: trianglesOf(region, this.data), pose: element.pose, color: styleColor('--mark'), opacity: 0.25, hull: true});
      }
    }
    if (!hulls) return bodies;
    for (const id of this.cutOf(element)) {
      const leaf = firstLeaf(mesh, id);
      const color = colorOf((0.58 + 0.381966 * index + 0.055 * (leaf % 5)) % 1, 0.55, 0.5 + 0.06 * (leaf % 3));
      bodies.push({triangles: trianglesOf(mesh.nodes[id].at, this.data), pose: element.pose, color, opacity: faded ? 0.07 : original ? 0.45 : 1, hull: true, faded});
    }
    return bodies;
  }

  showBodies() {
    const bodies = this.elements.flatMap((element, index) => this.bodiesOf(element, index));
    for (const body of this.checked('show-kept') && !this.selected ? this.data.models[this.model].kept : []) {
      bodies.push({triangles: trianglesOf(body.at, this.data), pose: body.pose, color: styleColor('--kept'), opacity: 1, hull: Boolean(body.at.shape)});
    }
    if (this.data.scene && this.checked('show-scene')) {
      bodies.push({triangles: trianglesOf(this.data.scene, this.data), pose: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], color: styleColor('--scene'), opacity: 0.35, hull: true});
    }
    this.view.show(bodies);
    this.tellCount();
    this.draw();
  }

  /** All of the robot, or the element. */
  frame() {
    const points = [];
    const add = (block, pose) => {
      const p = trianglesOf(block, this.data);
      for (let i = 0; i < p.length; i += 3) points.push(placed(pose, [p[i], p[i + 1], p[i + 2]]));
    };
    for (const body of this.selected ? [] : this.data.models[this.model].kept) add(body.at, body.pose);
    for (const element of this.selected ? [this.selected] : this.elements) {
      const mesh = this.data.meshes[element.mesh], leaves = mesh.nodes.filter((node) => node.left < 0).map((node) => node.at);
      for (const block of leaves.length > 0 ? leaves : [mesh.original]) add(block, element.pose);  // the hulls hold the mesh
    }
    this.camera.frame(points, this.stage.clientWidth / this.stage.clientHeight);
  }

  draw(moving = false) {
    if (this.waiting) cancelAnimationFrame(this.waiting);
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      if (this.stage.clientWidth === 0) return;
      this.view.draw(this.camera, styleColor('--stage'), moving);
      this.drawWorst();
    });
  }

  /** An arrow at the place where the hulls protrude most, of the element or else of the robot, with the distance that was found there. */
  drawWorst() {
    const overlay = byId('overlay');
    overlay.replaceChildren();
    if (!this.checked('show-worst') || !this.checked('show-hulls') || this.tolerance > 0) return;
    const worst = (this.selected ? [this.selected] : this.elements).reduce((a, b) => (b.found > (a ? a.found : 0) ? b : a), null);
    if (!worst) return;
    const project = this.camera.projection(this.stage.clientWidth, this.stage.clientHeight);
    const tip = project(...placed(worst.pose, worst.worst)), foot = project(...placed(worst.pose, worst.nearest));
    if (tip[2] <= 0) return;
    const dx = tip[0] - foot[0], dy = tip[1] - foot[1], length = Math.hypot(dx, dy);
    const [x, y] = length > 1 ? [dx / length, dy / length] : [0.7, -0.7];
    const far = [tip[0] + 60 * x, tip[1] + 60 * y], neck = [tip[0] + 9 * x, tip[1] + 9 * y];
    const add = (kind, attributes, text = '') => {
      const part = document.createElementNS('http://www.w3.org/2000/svg', kind);
      for (const [name, value] of Object.entries(attributes)) part.setAttribute(name, value);
      part.textContent = text;
      overlay.append(part);
    };
    add('line', {x1: far[0], y1: far[1], x2: neck[0], y2: neck[1], class: 'arrow'});
    add('path', {d: `M${tip[0]} ${tip[1]}L${neck[0] - 4 * y} ${neck[1] + 4 * x}L${neck[0] + 4 * y} ${neck[1] - 4 * x}Z`, class: 'head'});
    add('line', {x1: tip[0], y1: tip[1], x2: foot[0], y2: foot[1], class: 'gap'});
    const left = x < 0;
    add('text', {x: far[0] + (left ? -6 : 6), y: far[1] + 4, 'text-anchor': left ? 'end' : 'start'}, millimetres(worst.found));
  }

  // Selecting.

  select(element) {
    this.selected = element;
    byId('reset').disabled = !element;
    for (const row of document.querySelectorAll('tbody.selected')) row.classList.remove('selected');
    if (element) this.rowOf(element).classList.add('selected');
    this.frame();
    this.showBodies();
  }

  rowOf(element) {
    return document.querySelector(`#model-${this.model} tbody[data-row="${element.row}"]`);
  }

  chooseModel(model) {
    this.model = model;
    document.querySelectorAll('.model').forEach((section) => (section.hidden = section.id !== `model-${model}`));
    document.querySelectorAll('.of-model').forEach((section) => (section.hidden = section.dataset.model !== String(model)));
    this.setUpSlider();
    this.select(null);
  }
}

// The table.

/** Sorts by a column; again: the other way round. The most of a number comes first. */
function sortBy(table, column) {
  const heads = [...table.tHead.rows[0].cells], head = heads[column], numbers = head.classList.contains('number');
  const before = head.getAttribute('aria-sort');
  const order = before ? (before === 'ascending' ? 'descending' : 'ascending') : numbers ? 'descending' : 'ascending';
  for (const cell of heads) cell.removeAttribute('aria-sort');
  head.setAttribute('aria-sort', order);
  const value = (body) => body.rows[0].cells[column].dataset.value;
  const compare = (a, b) => (isNaN(value(a)) || isNaN(value(b)) ? value(a).localeCompare(value(b), 'en', {numeric: true}) : value(a) - value(b));
  const sign = order === 'ascending' ? 1 : -1;
  [...table.tBodies].sort((a, b) => sign * compare(a, b)).forEach((body) => table.append(body));
}

function setUpTables(page) {
  for (const table of document.querySelectorAll('table.links')) {
    [...table.tHead.rows[0].cells].forEach((cell, column) => cell.firstChild.addEventListener('click', () => sortBy(table, column)));
    table.addEventListener('click', (event) => {
      const body = event.target.closest('tbody');
      const element = body && page.elements.find((one) => one.row === Number(body.dataset.row));
      if (element) page.select(element === page.selected ? null : element);
    });
  }
  byId('filter').addEventListener('input', () => {
    const wanted = byId('filter').value.toLowerCase();
    for (const body of document.querySelectorAll('table.links tbody')) body.hidden = !body.textContent.toLowerCase().includes(wanted);
  });
  const models = byId('models');
  if (models) models.addEventListener('change', () => page.chooseModel(Number(models.value)));
}

const page = new Page(readData());
setUpTables(page);
