// SPDX-License-Identifier: GPL-3.0-or-later
// Atoms, dislocation lines and fault planes of a frame as objects of three.js.
import {
  BufferGeometry, CanvasTexture, Color, DoubleSide, Float32BufferAttribute, Mesh, MeshBasicMaterial, Points,
  PointsMaterial, ShapeUtils, Vector2, Vector3,
} from 'three';
import { Line2 } from 'three/examples/jsm/lines/Line2.js';
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';

import { digits, numbers } from './blocks.js';

/** A shaded ball, with which points are painted. */
function ball() {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const context = canvas.getContext('2d');
  const shade = context.createRadialGradient(24, 22, 2, 32, 32, 31);
  shade.addColorStop(0, '#fff');
  shade.addColorStop(0.45, '#ccc');
  shade.addColorStop(1, '#555');
  context.fillStyle = shade;
  context.beginPath();
  context.arc(32, 32, 31, 0, 2 * Math.PI);
  context.fill();
  return new CanvasTexture(canvas);
}

/** `perAngle`: 1/tan(half the angle of view), by which three.js does not multiply the size of points. */
export function atomsObject(group, perAngle) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(numbers(group.at), 3));
  const material = new PointsMaterial({ color: group.colour, map: ball(), size: group.diameter * perAngle,
                                        alphaTest: 0.5 });
  const object = new Points(geometry, material);
  object.userData = { layer: group.name, text: null };
  return object;
}

export function lineObject(line, unit) {
  const material = new LineMaterial({ color: new Color(line.colour), linewidth: line.guide ? 1 : 4 });
  const object = new Line2(new LineGeometry().setPositions(numbers(line.at)), material);
  const parts = [line.name, line.burgers && `b = ${line.burgers}`,
                 line.length && `length ${digits(line.length)} ${unit}`];
  object.userData = { layer: line.name, text: parts.filter(Boolean).join(', ') };
  return object;
}

/** The polygon in the plane of its corners, cut into triangles. */
function triangles(corners) {
  const normal = new Vector3();
  corners.forEach((a, k) => normal.add(new Vector3().crossVectors(a, corners[(k + 1) % corners.length])));
  normal.normalize();
  const across = new Vector3(1, 0, 0).cross(normal);
  if (across.lengthSq() < 0.1) across.set(0, 1, 0).cross(normal);
  across.normalize();
  const along = new Vector3().crossVectors(normal, across);
  return ShapeUtils.triangulateShape(corners.map((c) => new Vector2(c.dot(across), c.dot(along))), []);
}

export function planeObject(plane, unit) {
  const at = numbers(plane.at);
  const corners = Array.from({ length: at.length / 3 }, (_, k) => new Vector3().fromArray(at, 3 * k));
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(at, 3));
  geometry.setIndex(triangles(corners).flat());
  const material = new MeshBasicMaterial({ color: plane.colour, side: DoubleSide, transparent: true,
                                           opacity: 0.45, depthWrite: false });
  const object = new Mesh(geometry, material);
  const parts = [plane.name, plane.area && `area ${digits(plane.area)} ${unit}\u00b2`];
  object.userData = { layer: plane.name, text: parts.filter(Boolean).join(', ') };
  return object;
}
