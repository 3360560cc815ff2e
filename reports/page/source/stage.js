// SPDX-License-Identifier: GPL-3.0-or-later
// The camera of a 3-D view and how it moves; painted only when something changes.
import { Box3, Color, Group, PerspectiveCamera, Raycaster, Scene, Sphere, Vector2, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

import { styled } from './theme.js';

const angle = 35;  // of view [degrees]
const radians = (degrees) => (degrees * Math.PI) / 180;
export const perAngle = 1 / Math.tan(radians(angle / 2));

/** What paints by WebGL; null where there is none. */
export function painter() {
  try {
    return new WebGLRenderer({ antialias: true });
  } catch {
    return null;
  }
}

export class Stage {
  constructor(place, brush) {
    this.place = place;
    this.brush = brush;
    this.camera = new PerspectiveCamera(angle);
    this.content = new Group();
    this.scene = new Scene().add(this.content);
    this.frame = 0;
    brush.setPixelRatio(devicePixelRatio);
    brush.domElement.setAttribute('aria-hidden', 'true');
    place.append(brush.domElement);
    this.controls = new OrbitControls(this.camera, brush.domElement);
    this.controls.enableZoom = false;  // the wheel scrolls the page; shift and wheel zoom
    this.controls.addEventListener('change', () => this.repaint());
    this.resized = new ResizeObserver(() => this.fit());
    this.resized.observe(place);
  }

  fit() {
    const { clientWidth, clientHeight } = this.place;
    this.brush.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / Math.max(clientHeight, 1);
    this.camera.updateProjectionMatrix();
    this.repaint();
  }

  repaint() {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => {
      this.scene.background = new Color(styled('--back'));
      this.brush.render(this.scene, this.camera);
    });
  }

  /** Looks at all of the content, as the still picture does. */
  aim() {
    const { center, radius } = new Box3().setFromObject(this.content).getBoundingSphere(new Sphere());
    const distance = 0.8 * Math.max(radius, 1e-30) * perAngle;  // corners of the box may leave the picture
    this.controls.target.copy(center);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(0.45, -0.8, 0.4).normalize().multiplyScalar(distance).add(center);
    this.camera.near = distance / 100;
    this.camera.far = 10 * distance;
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  moved(from) {
    this.camera.position.copy(this.controls.target).add(from);
    this.controls.update();
    this.repaint();
  }

  zoom(factor) {
    this.moved(this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor));
  }

  /** Turns about the vertical and, not over the poles, up. */
  turn(around, up) {
    const from = this.camera.position.clone().sub(this.controls.target).applyAxisAngle(this.camera.up, around);
    const tilted = from.clone().applyAxisAngle(from.clone().cross(this.camera.up).normalize(), up);
    this.moved(Math.abs(tilted.clone().normalize().dot(this.camera.up)) < 0.99 ? tilted : from);
  }

  /** The nearest thing of the content with a text under a point of the place [pixels]. */
  under(x, y) {
    const ray = new Raycaster();
    ray.params.Line2 = { threshold: 4 };
    const { clientWidth, clientHeight } = this.place;
    ray.setFromCamera(new Vector2((2 * x) / clientWidth - 1, 1 - (2 * y) / clientHeight), this.camera);
    const things = this.content.children.filter((c) => c.visible && c.userData.text);
    return ray.intersectObjects(things, false)[0]?.object ?? null;
  }

  clear() {
    for (const { geometry, material } of this.content.children) {
      geometry.dispose();
      material.map?.dispose();
      material.dispose();
    }
    this.content.clear();
  }

  release() {
    cancelAnimationFrame(this.frame);
    this.resized.disconnect();
    this.controls.dispose();
    this.clear();
    this.brush.dispose();
    this.brush.forceContextLoss();
  }
}
