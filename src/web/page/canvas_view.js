// Draws without WebGL, on a plain canvas: every triangle with one shade, the furthest first. For browsers and systems without more.
// A view has bodies: {triangles (nine coordinates each), pose, color, opacity, hull}.
'use strict';

class CanvasView {
  constructor(canvas) {
    this.canvas = canvas;
    // Painted by the CPU: a system without WebGL at best emulates a GPU, which is far slower.
    this.pen = canvas.getContext('2d', {willReadFrequently: true});
    this.name = 'drawn without WebGL';
  }

  show(bodies) {
    this.bodies = bodies;
    for (const body of bodies) body.world = this.worldOf(body);
    this.total = bodies.reduce((sum, body) => sum + body.triangles.length / 9, 0);
  }

  /** Triangles where the robot has them, twelve numbers each: corners and normal. */
  worldOf(body) {
    const from = body.triangles, m = body.pose, world = new Float32Array(from.length / 9 * 12);
    for (let t = 0, w = 0; t < from.length; t += 9, w += 12) {
      for (let c = 0; c < 9; c += 3) {
        const p = placed(m, [from[t + c], from[t + c + 1], from[t + c + 2]]);
        world.set(p, w + c);
      }
      const edge = (c) => [0, 1, 2].map((k) => world[w + c + k] - world[w + k]);
      const a = edge(3), b = edge(6);
      const n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]], length = Math.hypot(...n) || 1;
      world.set(n.map((x) => x / length), w + 9);
    }
    return world;
  }

  /** Of what is visible: distance, body, shade and corners in pixels. */
  visible(camera, width, height, moving) {
    const project = camera.projection(width, height), eye = camera.eye, back = camera.backward, faces = [];
    const light = back.map((x, k) => x + 0.5 * camera.up[k] - 0.3 * camera.right[k]), norm = Math.hypot(...light);
    const most = 40000;  // to keep turning smooth
    const behind = 0.02 * camera.distance;  // originals, whose faces lie in those of the hulls
    for (const body of this.bodies) {
      if (moving && this.total > most && !body.hull) continue;
      for (let w = 0, p = body.world; w < p.length; w += 12) {
        const towards = (eye[0] - p[w]) * p[w + 9] + (eye[1] - p[w + 1]) * p[w + 10] + (eye[2] - p[w + 2]) * p[w + 11];
        if (towards < 0 && body.hull) continue;
        const a = project(p[w], p[w + 1], p[w + 2]), b = project(p[w + 3], p[w + 4], p[w + 5]), c = project(p[w + 6], p[w + 7], p[w + 8]);
        if (Math.min(a[2], b[2], c[2]) < 1e-3 * camera.distance) continue;
        const shade = Math.abs(p[w + 9] * light[0] + p[w + 10] * light[1] + p[w + 11] * light[2]) / norm;
        faces.push({depth: (a[2] + b[2] + c[2]) / 3 + (body.hull ? 0 : behind), body, shade: 0.45 + 0.55 * shade, a, b, c});
      }
    }
    return faces.sort((one, other) => other.depth - one.depth);
  }

  draw(camera, background, moving) {
    const scale = window.devicePixelRatio || 1, width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    this.canvas.width = Math.round(width * scale);
    this.canvas.height = Math.round(height * scale);
    const pen = this.pen;
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    pen.fillStyle = `rgb(${background.map((x) => Math.round(255 * x))})`;
    pen.fillRect(0, 0, width, height);
    pen.lineJoin = 'round';
    pen.lineWidth = 0.7;
    for (const face of this.visible(camera, width, height, moving)) {
      const color = `rgba(${face.body.color.map((x) => Math.round(255 * x * face.shade))},${face.body.opacity})`;
      pen.beginPath();
      pen.moveTo(face.a[0], face.a[1]);
      pen.lineTo(face.b[0], face.b[1]);
      pen.lineTo(face.c[0], face.c[1]);
      pen.closePath();
      pen.fillStyle = color;
      pen.fill();
      if (face.body.opacity < 1) continue;
      pen.strokeStyle = color;  // no gaps between neighbours
      pen.stroke();
    }
  }
}
