// What a ray has gathered, and how a piece of the volume adds to it (Max, "Optical models", 1995).

struct Radiance
{
  vec3 color; // premultiplied
  real transmittance;
};

// (1 - exp(-D)) / D without cancellation: the series below 1/8 is good to 4e-8. transmitted: exp(-D).
real meanTransmittance(real depth, real transmitted)
{
  real series = real(1) -
    depth * (real(0.5) - depth * (real(1) / real(6) - depth * (real(1) / real(24) - depth / real(120))));
  return depth < real(0.125) ? series : (real(1) - transmitted) / depth;
}

// mean: of C tau and tau; length in scalar opacity unit distances; transmitted: exp(-length mean tau).
void absorb(INOUT(Radiance) radiance, vec4 mean, real opticalLength, real transmitted)
{
  real depth = mean.w * opticalLength;
  real share = meanTransmittance(depth, transmitted);
  real weight = radiance.transmittance * share * opticalLength;
  // Colours are at most 1; rounding could make their mean a little more, and pixels with it.
  radiance.color =
    radiance.color + vec3(min(mean.x, mean.w), min(mean.y, mean.w), min(mean.z, mean.w)) * weight;
  radiance.transmittance = radiance.transmittance * max(real(1) - depth * share, real(0));
}
