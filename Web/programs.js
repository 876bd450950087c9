// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Programs of WebGL 2: compiled once per variant; their uniforms and textures are set by name.
import {composeShader} from "./shader_source.js";
import {rowShift} from "./textures.js";

function compiled(gl, type, text)
{
  const shader = gl.createShader(type);
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  return shader;
}

const SETTERS = {
  FLOAT: "uniform1fv",
  FLOAT_VEC2: "uniform2fv",
  FLOAT_VEC3: "uniform3fv",
  FLOAT_VEC4: "uniform4fv",
  INT: "uniform1iv",
  INT_VEC3: "uniform3iv",
  BOOL: "uniform1iv"
};

class Program
{
  constructor(gl, vertexText, fragmentText)
  {
    this.gl = gl;
    this.shaders =
      [compiled(gl, gl.VERTEX_SHADER, vertexText), compiled(gl, gl.FRAGMENT_SHADER, fragmentText)];
    this.handle = gl.createProgram();
    this.shaders.forEach((shader) => gl.attachShader(this.handle, shader));
    gl.linkProgram(this.handle);
  }

  /** After the GL has compiled it, which it may do beside us. */
  check()
  {
    const gl = this.gl;
    if (!gl.getProgramParameter(this.handle, gl.LINK_STATUS) && !gl.isContextLost())
    {
      const log = this.shaders.map((shader) => gl.getShaderInfoLog(shader)).join("\n") +
                  gl.getProgramInfoLog(this.handle);
      throw new Error(`The shaders of this page could not be built by this browser: ${log}`);
    }
    this.uniforms = [];
    const count = gl.getProgramParameter(this.handle, gl.ACTIVE_UNIFORMS) || 0;
    for (let i = 0; i < count; ++i)
    {
      const {name, type, size} = gl.getActiveUniform(this.handle, i);
      const plain = name.replace("[0]", "");
      const elements = size > 1 && this.isSampler(type) ? size : 1;
      for (let k = 0; k < elements; ++k)
      {
        const element = elements > 1 ? `${plain}[${k}]` : plain;
        this.uniforms.push({
          name: element,
          type,
          location: gl.getUniformLocation(this.handle, elements > 1 ? element : name)
        });
      }
    }
    this.shaders.forEach((shader) => gl.deleteShader(shader));
  }

  isSampler(type)
  {
    const gl = this.gl;
    return [gl.SAMPLER_2D, gl.UNSIGNED_INT_SAMPLER_2D, gl.SAMPLER_2D_ARRAY].includes(type);
  }

  /**
   * Uses the program with values (arrays of numbers, matrices column by column) and textures
   * ({target, texture}) by name.
   */
  use(values, textures)
  {
    const gl = this.gl;
    gl.useProgram(this.handle);
    let unit = 0;
    for (const {name, type, location} of this.uniforms)
    {
      if (this.isSampler(type))
      {
        const bound = textures[name];
        if (!bound)
        {
          throw new Error(`the page has no texture ${name}`);
        }
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(bound.target, bound.texture);
        gl.uniform1i(location, unit++);
      }
      else
      {
        // What has no value didn't matter to the mapper's GL, which found out that no result needs
        // it.
        const value = values[name];
        if (value)
        {
          this.set(type, location, value);
        }
      }
    }
  }

  set(type, location, value)
  {
    const gl = this.gl;
    if (type === gl.FLOAT_MAT4 || type === gl.FLOAT_MAT3)
    {
      gl[type === gl.FLOAT_MAT4 ? "uniformMatrix4fv" : "uniformMatrix3fv"](location, false, value);
      return;
    }
    const setter = Object.keys(SETTERS).find((name) => gl[name] === type);
    gl[SETTERS[setter]](location, value);
  }
}

export class Programs
{
  /** files: texts of shaders; symbols: names of all features. */
  constructor(gl, files, symbols)
  {
    this.gl = gl;
    this.files = files;
    this.symbols = symbols;
    this.known = new Map();
  }

  text(entry, features)
  {
    return composeShader(this.files, entry, this.symbols, [...features, "ES"],
      `#define BUFFER_ROW_SHIFT ${rowShift(this.gl)}\n`);
  }

  /**
   * The program of two entry points with these features, ready to be used. Its check() throws if
   * the GL refuses it.
   */
  async get(vertex, fragment, features = [])
  {
    const key = [vertex, fragment, ...[...features].sort()].join(" ");
    if (!this.known.has(key))
    {
      const program =
        new Program(this.gl, this.text(vertex, features), this.text(fragment, features));
      this.known.set(key, this.whenCompiled(program));
    }
    return this.known.get(key);
  }

  // Without blocking the page where the GL compiles beside it.
  async whenCompiled(program)
  {
    const gl = this.gl;
    const extension = gl.getExtension("KHR_parallel_shader_compile");
    while (extension && !gl.isContextLost() &&
           !gl.getProgramParameter(program.handle, extension.COMPLETION_STATUS_KHR))
    {
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
    program.check();
    return program;
  }
}
