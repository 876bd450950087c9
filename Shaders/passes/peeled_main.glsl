// The picture between translucent surfaces. vtkDualDepthPeelingPass replaces the tag below by code that reads the
// depths of such surfaces, calls initializeRayCast() once and castRay() for one or two parts of the pixel's ray, and
// writes colours to its own targets. The names are VTK's.

const float g_opacityThreshold = 1.0 - 1.0 / 255.0;

PixelRay peeledRay;

void initializeRayCast() { peeledRay = seenPixelRay(); }

// Premultiplied colour and opacity between two depths of the window, 0..1.
vec4 castRay(float begin, float end)
{
  PixelRay part = peeledRay;
  if (begin > 0.0)
  {
    part.depthBegin = max(part.depthBegin, depthAt(part.center, part.ray, begin));
  }
  part.depthEnd = min(part.depthEnd, depthAt(part.center, part.ray, end));
  return colorOf(part, marchPixel(part));
}

void main()
{
  vec2 in_inverseWindowSize = 1.0 / viewport.zw;
  //VTK::CallWorker::Impl
}
