// The ray of a fragment's pixel. Discards helpers and pixels that see nothing of the volume.
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
