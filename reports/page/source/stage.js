// SPDX-License-Identifier: GPL-3.0-or-later
// Camera, light of a 3-D view and how it is turned; it is painted only when something changes.
import { Box3, Color, Group, PerspectiveCamera, Raycaster, Scene, Sphere, Vector2, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

import { styled } from './theme.js';

export const angle = 35;  // of view [degrees]
export const perAngle = 1 / Math.tan((angle / 2) * Math.PI / 180);

function renderer() {
  try {
    return new WebGLRenderer({ antialias: true });
  } catch {
    return null;  // no WebGL: the still picture stays
  }
}

/** The stage in an element; null without WebGL. */
export function makeStage(place) {
  const painter = renderer();
  if (!painter) return null;
  const scene = new Scene(), camera = new PerspectiveCamera(angle, 1, 0.1, 1000), content = new Group();
  scene.add(content);
  painter.setPixelRatio(devicePixelRatio);
  place.append(painter.domElement);
  painter.domElement.setAttribute('aria-hidden', 'true');
  const controls = new OrbitControls(camera, painter.domElement);
  controls.enableZoom = false;  // the wheel scrolls the page; shift and wheel zoom
  let frame = 0;
  const paint = () => {
    scene.background = new Color(styled('--back'));
    painter.render(scene, camera);
  };
  const repaint = () => (cancelAnimationFrame(frame), (frame = requestAnimationFrame(paint)));
  const aimed = () => {
    const ball = new Box3().setFromObject(content).getBoundingSphere(new Sphere());
    const radius = ball.radius > 0 ? ball.radius : 1;
    const distance = 0.8 * radius * perAngle;  // corners of the box may leave the picture
    controls.target.copy(ball.center);
    camera.position.set(0.45, -0.8, 0.4).normalize().multiplyScalar(distance).add(ball.center);
    camera.up.set(0, 0, 1);
    camera.near = distance / 100;
    camera.far = 10 * distance;
    camera.updateProjectionMatrix();
    controls.update();
  };
  const resized = new ResizeObserver(() => {
    painter.setSize(place.clientWidth, place.clientHeight);
    camera.aspect = place.clientWidth / Math.max(place.clientHeight, 1);
    camera.updateProjectionMatrix();
    repaint();
  });
  resized.observe(place);
  controls.addEventListener('change', repaint);
  const zoom = (factor) => {
    camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
    controls.update();
    repaint();
  };
  const turn = (around, up) => {
    const from = camera.position.clone().sub(controls.target);
    from.applyAxisAngle(camera.up, around);
    const side = from.clone().cross(camera.up).normalize();
    const tilted = from.clone().applyAxisAngle(side, up);
    const slope = Math.abs(tilted.clone().normalize().dot(camera.up));
    camera.position.copy(controls.target).add(slope < 0.99 ? tilted : from);
    controls.update();
    repaint();
  };
  /** The nearest thing of the content with a text under a point of the element [pixels]. */
  const under = (x, y) => {
    const ray = new Raycaster();
    ray.params.Line2 = { threshold: 4 };
    ray.setFromCamera(new Vector2((2 * x) / place.clientWidth - 1, 1 - (2 * y) / place.clientHeight), camera);
    const things = content.children.filter((c) => c.visible && c.userData.text);
    return ray.intersectObjects(things, false)[0]?.object ?? null;
  };
  const clear = () => {
    for (const child of content.children) {
      child.geometry.dispose();
      child.material.map?.dispose();
      child.material.dispose();
    }
    content.clear();
  };
  const release = () => {
    cancelAnimationFrame(frame);
    resized.disconnect();
    controls.dispose();
    clear();
    painter.dispose();
    painter.forceContextLoss();
  };
  return { content, aimed, repaint, zoom, turn, under, clear, release };
}
