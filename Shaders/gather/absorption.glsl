// How a piece of the volume adds to what a ray has gathered (Max, "Optical models", 1995).

// What a piece does to the light that comes into it.
struct Absorption
{
  real thickness; // in scalar opacity unit distances
  real depth;         // optical depth
  real evenly;        // (1 - exp(-depth)) / depth
  real absorbed;      // 1 - exp(-depth)
};

// mean: of C tau and tau. The series below 1/8, good to 4e-8, has no cancellation.
Absorption absorption(vec4 mean, real thickness)
{
  Absorption piece;
  piece.thickness = thickness;
  real depth = mean.w * thickness;
  real series = real(1) -
    depth * (real(0.5) - depth * (real(1) / real(6) - depth * (real(1) / real(24) - depth / real(120))));
  piece.depth = depth;
  piece.evenly = depth < real(0.125) ? series : (real(1) - exp(-depth)) / depth;
  piece.absorbed = depth * piece.evenly;
  return piece;
}

void absorb(INOUT(Radiance) radiance, vec3 emitted, Absorption piece)
{
  radiance.color = radiance.color + emitted * (radiance.transmittance * piece.evenly * piece.thickness);
  radiance.transmittance = radiance.transmittance * max(real(1) - piece.absorbed, real(0));
}

#if TETMARCH_NAN_SHOWN
// A piece in which the scalar is not finite: of one colour and extinction, without gradient and so without light.
void absorbNan(INOUT(Radiance) radiance, real thickness)
{
#if TETMARCH_SHOW_ILLUMINATION
  vec3 color = vec3(real(1), real(1), real(1));
#elif TETMARCH_SHOW_GRADIENTS
  vec3 color = vec3(real(0.5), real(0.5), real(0.5)); // as where there is none
#else
  vec3 color = vec3(nanColor.x, nanColor.y, nanColor.z);
#endif
  Absorption piece = absorption(nanColor, thickness);
  absorb(radiance, color * nanColor.w, piece);
}
#endif
