// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws the constant scene of vtkjs_page.py by vtk.js; frame() and picture() are for scripts.

const {Core, OpenGL} = vtk.Rendering;

function imageOf({dimensions, origin, spacing, values})
{
  const image = vtk.Common.DataModel.vtkImageData.newInstance({origin, spacing});
  image.setDimensions(...dimensions);
  image.getPointData().setScalars(vtk.Common.Core.vtkDataArray.newInstance(
    {name: "values", values: Uint8Array.from(atob(values), (letter) => letter.charCodeAt(0))}));
  return image;
}

// vtk.js continues an image by half a voxel beyond its outermost samples; other mappers of VTK
// don't.
function clipToSamples(mapper, {origin, spacing, dimensions})
{
  [0, 1, 2].forEach((axis) => [1, -1].forEach((side) => {
    const normal = [0, 0, 0];
    normal[axis] = side;
    const corner = side > 0 ? origin : origin.map((x, a) => x + spacing[a] * (dimensions[a] - 1));
    mapper.addClippingPlane(
      vtk.Common.DataModel.vtkPlane.newInstance({origin: [...corner], normal}));
  }));
}

function volumeOf(scene, image)
{
  const {functions, unitDistance, sampleDistance} = scene;
  const colors = Core.vtkColorTransferFunction.newInstance();
  functions.color.forEach((point) => colors.addRGBPoint(...point));
  const opacities = vtk.Common.DataModel.vtkPiecewiseFunction.newInstance();
  functions.opacity.forEach((point) => opacities.addPoint(...point));
  const mapper = Core.vtkVolumeMapper.newInstance({
    sampleDistance,
    imageSampleDistance: 1,
    autoAdjustSampleDistances: false,
    maximumSamplesPerRay: 1 << 20
  });
  mapper.setInputData(image);
  clipToSamples(mapper, scene);
  const volume = Core.vtkVolume.newInstance();
  volume.setMapper(mapper);
  const property = volume.getProperty();
  property.setRGBTransferFunction(0, colors);
  property.setScalarOpacity(0, opacities);
  property.setScalarOpacityUnitDistance(0, unitDistance);
  property.setInterpolationTypeToLinear();
  property.setShade(false);
  return volume;
}

const renderWindow = Core.vtkRenderWindow.newInstance();
const renderer = Core.vtkRenderer.newInstance({background: scene.background});
renderWindow.addRenderer(renderer);
const view = OpenGL.vtkRenderWindow.newInstance();
view.setContainer(document.querySelector("div"));
view.setSize(...scene.size);
renderWindow.addView(view);
const interactor = Core.vtkRenderWindowInteractor.newInstance();
interactor.setView(view);
interactor.initialize();
renderer.addVolume(volumeOf(scene, imageOf(scene)));
const camera = renderer.getActiveCamera();
camera.set(scene.camera);
renderer.resetCameraClippingRange();

/** Milliseconds of a frame after the camera was turned, until the GL has finished. */
window.frame = (degrees) => {
  camera.azimuth(degrees);
  renderer.resetCameraClippingRange();
  const begun = performance.now();
  renderWindow.render();
  const gl = view.getContext();
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return performance.now() - begun;
};
/** The frame as a data URL of a PNG. */
window.picture = () => {
  renderWindow.render();
  return view.getCanvas().toDataURL();
};
window.frame(0);
document.title = "ready";
