// The ray of a fragment's pixel. Discards helpers and pixels whose ray misses the volume.
PixelRay seenPixelRay()
{
  if (IS_HELPER)
  {
    discard;
  }
  PixelRay pixel = pixelRay(gl_FragCoord.xy);
  if (!pixel.seen)
  {
    discard;
  }
  return pixel;
}
