// Draws with three.js, where the page holds it and the browser has WebGL. See canvas_view.js for what a view is given.
'use strict';

function hasWebGl() {
  const context = document.createElement('canvas').getContext('webgl');
  const loser = context && context.getExtension('WEBGL_lose_context');
  if (loser) loser.loseContext();
  return Boolean(context);
}

class ThreeView {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    this.name = `drawn with three.js r${THREE.REVISION}`;
    this.camera = new THREE.PerspectiveCamera();
    this.camera.up.set(0, 0, 1);
    this.scene = new THREE.Scene();
    this.light = new THREE.DirectionalLight(0xffffff, 0.75);
    this.group = new THREE.Group();
    this.scene.add(new THREE.AmbientLight(0xffffff, 0.45), this.light, this.light.target, this.group);
    this.geometries = new Map();
  }

  /** By the array of triangles, each once. Without an index every triangle has its own normal. */
  geometryOf(triangles, hull) {
    let known = this.geometries.get(triangles);
    if (!known) {
      const solid = new THREE.BufferGeometry();
      solid.setAttribute('position', new THREE.BufferAttribute(triangles, 3));
      solid.computeVertexNormals();
      known = {solid, edges: hull ? new THREE.EdgesGeometry(solid, 12) : null};
      this.geometries.set(triangles, known);
    }
    return known;
  }

  show(bodies) {
    for (const old of this.group.children) old.material.dispose();
    this.group.children = [];
    for (const body of bodies) this.add(body);
  }

  add(body) {
    const geometry = this.geometryOf(body.triangles, body.hull), clear = body.opacity < 1;
    const color = new THREE.Color(...body.color);
    const pose = new THREE.Matrix4().set(...body.pose, 0, 0, 0, 1);
    const place = (object) => {
      object.matrixAutoUpdate = false;
      object.matrix.copy(pose);
      this.group.add(object);
    };
    place(new THREE.Mesh(geometry.solid, new THREE.MeshLambertMaterial({
      color, opacity: body.opacity, transparent: clear, depthWrite: !clear, side: body.hull ? THREE.FrontSide : THREE.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: body.hull ? 1 : 2, polygonOffsetUnits: body.hull ? 1 : 2,
    })));
    if (!geometry.edges || body.faded) return;
    const line = new THREE.LineBasicMaterial({color: color.clone().multiplyScalar(0.6), transparent: true, opacity: Math.min(1, 1.4 * body.opacity)});
    place(new THREE.LineSegments(geometry.edges, line));
  }

  draw(camera, background) {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight, eye = camera.eye;
    this.renderer.setPixelRatio(window.devicePixelRatio || 1);
    this.renderer.setSize(width, height, false);
    this.renderer.setClearColor(new THREE.Color(...background));
    this.camera.fov = FIELD_OF_VIEW * 180 / Math.PI;
    this.camera.aspect = width / height;
    this.camera.near = camera.distance / 200;
    this.camera.far = camera.distance * 50;
    this.camera.position.set(...eye);
    this.camera.lookAt(...camera.target);
    this.camera.updateProjectionMatrix();
    const at = eye.map((x, k) => x + camera.distance * (0.5 * camera.up[k] - 0.3 * camera.right[k]));
    this.light.position.set(...at);
    this.light.target.position.set(...camera.target);
    this.light.target.updateMatrixWorld();
    this.renderer.render(this.scene, this.camera);
  }
}
