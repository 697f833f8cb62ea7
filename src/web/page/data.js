// What src/web/view_data.cpp wrote: meshes on a grid of integers, and trees of hulls. Lengths in metres.
'use strict';

function readData() {
  const data = JSON.parse(document.getElementById('view-data').textContent);
  const text = atob(document.getElementById('geometry').textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  data.buffer = bytes.buffer;
  return data;
}

/** The triangles of a block one after another, nine coordinates each, in the mesh's frame. Kept with the block. */
function trianglesOf(block, data) {
  if (block.soup) return block.soup;
  if (block.shape) return block.soup = new Float32Array(trianglesOfShape(block).flatMap((p) => placed(block.pose, p)));
  const points = new Uint16Array(data.buffer, block.offset, 3 * block.vertices);
  const start = block.offset + 4 * Math.ceil(6 * block.vertices / 4);
  const Index = {1: Uint8Array, 2: Uint16Array, 4: Uint32Array}[block.index];
  const corners = new Index(data.buffer, start, 3 * block.triangles);
  const soup = new Float32Array(9 * block.triangles);
  for (let i = 0; i < corners.length; ++i) {
    for (let k = 0; k < 3; ++k) soup[3 * i + k] = block.origin[k] + block.step * points[3 * corners[i] + k];
  }
  return block.soup = soup;
}

/** The corners of a primitive's triangles in its own frame, outward. A sphere is a stack of rings, a cylinder one of two with caps. */
function trianglesOfShape({shape, size}) {
  if (shape === 'box') {
    const corner = (i) => [0, 1, 2].map((k) => (i >> k & 1 ? 0.5 : -0.5) * size[k]);
    return [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5].map(corner);
  }
  const sides = 32, [radius, length] = size, corners = [];
  const rings = shape === 'cylinder' ? [[0, -length / 2], [radius, -length / 2], [radius, length / 2], [0, length / 2]] :
    Array.from({length: sides / 2 + 1}, (_, i) => [radius * Math.sin(2 * Math.PI * i / sides), -radius * Math.cos(2 * Math.PI * i / sides)]);
  const at = ([r, z], side) => [r * Math.cos(2 * Math.PI * side / sides), r * Math.sin(2 * Math.PI * side / sides), z];
  for (let i = 1; i < rings.length; ++i) {
    for (let side = 0; side < sides; ++side) {
      const [a, b, c, d] = [at(rings[i - 1], side), at(rings[i - 1], side + 1), at(rings[i], side + 1), at(rings[i], side)];
      if (i > 1) corners.push(a, b, c);
      if (i < rings.length - 1) corners.push(a, c, d);
    }
  }
  return corners;
}

/** Where a point of an element's frame is when the robot is at rest. `pose`: 3 x 4 by rows. */
function placed(pose, p) {
  return [0, 4, 8].map((row) => pose[row] * p[0] + pose[row + 1] * p[1] + pose[row + 2] * p[2] + pose[row + 3]);
}

/** The nodes of a mesh that are no other's child: one, unless it was not merged. */
function rootsOf(mesh) {
  const children = new Set();
  for (const node of mesh.nodes) children.add(node.left).add(node.right);
  return mesh.nodes.map((node, id) => id).filter((id) => !children.has(id));
}

/** The coarsest cut whose nodes protrude by at most `tolerance`, but for leaves. */
function cutAt(mesh, tolerance) {
  const open = rootsOf(mesh), cut = [];
  while (open.length > 0) {
    const id = open.pop(), node = mesh.nodes[id];
    if (node.left < 0 || node.bound <= tolerance) cut.push(id);
    else open.push(node.left, node.right);
  }
  return cut;
}

/** The first leaf below a node: what gives its hull a colour that lasts while hulls merge. */
function firstLeaf(mesh, id) {
  while (mesh.nodes[id].left >= 0) id = mesh.nodes[id].left;
  return id;
}

/** The bounds at which some mesh of a model gets fewer hulls, ascending. */
function stepsOf(model, data) {
  const bounds = new Set();
  for (const element of model.elements) {
    for (const node of data.meshes[element.mesh].nodes) if (node.left >= 0) bounds.add(node.bound);
  }
  return [...bounds].sort((a, b) => a - b);
}
