// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The camera as options of tetmarch-render and as Python. A number is the shortest text that is
// read back as the same number.

/** camera: as of Camera.toObject(); size: of the picture, in pixels. */
export function cameraCommand(camera, size)
{
  const numbers = [...camera.position, ...camera.focalPoint, ...camera.viewUp, camera.viewAngle];
  const parallel = camera.parallelProjection ? ` --parallel-scale ${camera.parallelScale}` : "";
  return `tetmarch-render INPUT --camera=${numbers.join(",")}${parallel} --size ${size.join("x")}`;
}

export function cameraPython(camera, size)
{
  const vector = (numbers) => `(${numbers.join(", ")})`;
  const entries = [
    `"position": ${vector(camera.position)}`,
    `"focal_point": ${vector(camera.focalPoint)}`,
    `"view_up": ${vector(camera.viewUp)}`,
    `"view_angle": ${camera.viewAngle}`,
  ];
  if (camera.parallelProjection)
  {
    entries.push(`"parallel_scale": ${camera.parallelScale}`);
  }
  return `camera = {${entries.join(", ")}}\n` +
         `vtktetmarch.figure(data, size=${vector(size)}, camera=camera)`;
}
