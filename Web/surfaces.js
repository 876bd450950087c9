// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Opaque triangles, drawn with WebGL 2 into the bound framebuffer: colours and depths.
import {invert, multiply, transformPoint, transpose} from "./matrices.js";
import {normalize} from "./vectors.js";

const MOST_LIGHTS = 8; // of the shader

/** The entry points of the program of surfaces. */
export const SURFACE_SHADERS = ["web/surface.vert.glsl", "web/surface.frag.glsl"];

// Of the attributes in the shader, by their locations: member of a surface, numbers a point, GL
// type of a number, and whether integers are 0..1.
/** @type {[string, number, string, boolean][]} */
const ATTRIBUTES = [
  ["positions", 3, "FLOAT", false],
  ["normals", 3, "FLOAT", false],
  ["colors", 4, "UNSIGNED_BYTE", true],
  ["tableCoordinates", 2, "FLOAT", false],
];

// A headlight without other lights has a formula of its own, as in VTK.
function lightUniforms(lights, viewMatrix)
{
  const inView = ({followsCamera, direction}) =>
    normalize(followsCamera ? direction : transformPoint(viewMatrix, [...direction, 0]));
  const padded = (numbers) => [...numbers, ...Array(3 * MOST_LIGHTS - numbers.length).fill(0)];
  const [first] = lights;
  return {
    isHeadlight:
      [Number(lights.length === 1 && first.followsCamera && first.direction.join() === "0,0,-1")],
    lightCount: [lights.length],
    lightDirections: padded(lights.flatMap((light) => inView(light).slice(0, 3))),
    lightColors: padded(lights.flatMap(({color}) => color)),
  };
}

// Colours of 4 bytes, in rows; VTK takes the nearest one.
function colorTable(gl, bytes, width)
{
  const bound = {target: gl.TEXTURE_2D, texture: gl.createTexture()};
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(bound.target, bound.texture);
  for (const name of ["MIN_FILTER", "MAG_FILTER"])
  {
    gl.texParameteri(bound.target, gl[`TEXTURE_${name}`], gl.NEAREST);
  }
  for (const name of ["WRAP_S", "WRAP_T"])
  {
    gl.texParameteri(bound.target, gl[`TEXTURE_${name}`], gl.CLAMP_TO_EDGE);
  }
  const size = [width, bytes.length / 4 / width];
  gl.texImage2D(bound.target, 0, gl.RGBA8, ...size, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return bound;
}

class Triangles
{
  constructor(gl, surface, archive)
  {
    this.gl = gl;
    this.surface = surface;
    this.buffers = [];
    this.vertexArray = gl.createVertexArray();
    gl.bindVertexArray(this.vertexArray);
    ATTRIBUTES.forEach(([name, ...layout], location) => {
      if (surface[name] !== null)
      {
        this.fill(gl.ARRAY_BUFFER, archive.array(surface[name]));
        this.attach(location, ...layout);
      }
    });
    const indices = archive.array(surface.triangles);
    this.fill(gl.ELEMENT_ARRAY_BUFFER, indices);
    this.count = indices.length;
    gl.bindVertexArray(null);
    this.table = surface.table === null
                   ? colorTable(gl, new Uint8Array(4), 1)
                   : colorTable(gl, archive.array(surface.table), surface.tableWidth);
  }

  fill(target, array)
  {
    const buffer = this.gl.createBuffer();
    this.buffers.push(buffer);
    this.gl.bindBuffer(target, buffer);
    this.gl.bufferData(target, array, this.gl.STATIC_DRAW);
  }

  attach(location, size, type, normalized)
  {
    this.gl.enableVertexAttribArray(location);
    this.gl.vertexAttribPointer(location, size, this.gl[type], normalized, 0, 0);
  }

  uniforms(camera, aspect)
  {
    const {surface} = this;
    const toView = multiply(camera.viewMatrix(), surface.matrix);
    const fromView = invert(toView);
    return fromView && {
      dataToView: transpose(toView),
      dataToClip: transpose(multiply(camera.projectionMatrix(aspect), toView)),
      normalToView: [0, 4, 8].flatMap((row) => fromView.slice(row, row + 3)),
      hasNormals: [Number(surface.normals !== null && !surface.flat)],
      hasColors: [Number(surface.colors !== null)],
      hasTable: [Number(surface.table !== null)],
      isLit: [Number(surface.lighting && surface.lights.length > 0)],
      ...lightUniforms(surface.lights, camera.viewMatrix()),
      isParallel: [Number(camera.parallelProjection)],
      ambientColor: surface.ambientColor,
      diffuseColor: surface.color,
      specularColor: surface.specularColor.map((x) => x * surface.specular),
      ambient: [surface.ambient],
      diffuse: [surface.diffuse],
      specularPower: [surface.specularPower],
    };
  }

  cull()
  {
    const {gl, surface: {frontFaces, backFaces}} = this;
    const all = frontFaces && backFaces;
    all ? gl.disable(gl.CULL_FACE) : gl.enable(gl.CULL_FACE);
    gl.cullFace(frontFaces ? gl.BACK : backFaces ? gl.FRONT : gl.FRONT_AND_BACK);
  }

  /** A surface with a singular matrix is not seen. */
  draw(program, camera, aspect)
  {
    const {gl} = this;
    const uniforms = this.uniforms(camera, aspect);
    if (uniforms)
    {
      program.use(uniforms, {colorTable: this.table});
      this.cull();
      gl.bindVertexArray(this.vertexArray);
      gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0);
    }
  }

  release()
  {
    this.buffers.forEach((buffer) => this.gl.deleteBuffer(buffer));
    this.gl.deleteVertexArray(this.vertexArray);
    this.gl.deleteTexture(this.table.texture);
  }
}

/** The arrays that surfaces need, by their indices. */
export function surfaceArrays(surfaces)
{
  const names = ["triangles", "table", ...ATTRIBUTES.map(([name]) => name)];
  return surfaces.flatMap((surface) => names.map((name) => surface[name]))
    .filter((index) => index !== null);
}

export class Surfaces
{
  /** archive has loaded the arrays of the surfaces; program: that of SURFACE_SHADERS. */
  constructor(gl, surfaces, archive, program)
  {
    this.gl = gl;
    this.program = program;
    this.parts = surfaces.map((surface) => new Triangles(gl, surface, archive));
  }

  /** aspect: width over height. */
  draw(camera, aspect)
  {
    const {gl} = this;
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.depthMask(true);
    this.parts.forEach((part) => part.draw(this.program, camera, aspect));
    gl.bindVertexArray(null);
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.DEPTH_TEST);
  }

  release() { this.parts.forEach((part) => part.release()); }
}
