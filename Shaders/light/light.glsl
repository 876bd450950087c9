// The light at a point of the volume: it multiplies the volume's own colour, and adds highlights.

struct Light
{
  vec3 diffuse;  // factor of the volume's own colour
  vec3 specular; // added to it
};

Light noLight()
{
  Light light;
  light.diffuse = vec3(real(0), real(0), real(0));
  light.specular = light.diffuse;
  return light;
}

Light addLight(Light p, Light q)
{
  p.diffuse = p.diffuse + q.diffuse;
  p.specular = p.specular + q.specular;
  return p;
}

Light dimLight(Light p, real factor)
{
  p.diffuse = p.diffuse * factor;
  p.specular = p.specular * factor;
  return p;
}

Light mixLight(Light p, Light q, real fraction)
{
  p.diffuse = p.diffuse + (q.diffuse - p.diffuse) * fraction;
  p.specular = p.specular + (q.specular - p.specular) * fraction;
  return p;
}

// The light at a point, separated by knowledge of its transmittance.
struct Illumination
{
  Light direct; // transmittance included
#if TETMARCH_HEADLIGHT_SHADOWS
  Light head;   // from the eye, not yet absorbed: its transmittance is that of the ray
#endif
#if TETMARCH_SAMPLED_BEAMS
  // From each light that casts shadows, not yet absorbed. A software renderer would write an array lane by lane.
  Light beamA;
#if TETMARCH_SEVERAL_SHADOWS
  Light beamB;
  Light beamC;
#endif
#endif
};

Illumination noIllumination()
{
  Illumination lit;
  lit.direct = noLight();
#if TETMARCH_HEADLIGHT_SHADOWS
  lit.head = noLight();
#endif
#if TETMARCH_SAMPLED_BEAMS
  lit.beamA = noLight();
#if TETMARCH_SEVERAL_SHADOWS
  lit.beamB = noLight();
  lit.beamC = noLight();
#endif
#endif
  return lit;
}

Illumination mixIllumination(Illumination p, Illumination q, real fraction)
{
  p.direct = mixLight(p.direct, q.direct, fraction);
#if TETMARCH_HEADLIGHT_SHADOWS
  p.head = mixLight(p.head, q.head, fraction);
#endif
#if TETMARCH_SAMPLED_BEAMS
  p.beamA = mixLight(p.beamA, q.beamA, fraction);
#if TETMARCH_SEVERAL_SHADOWS
  p.beamB = mixLight(p.beamB, q.beamB, fraction);
  p.beamC = mixLight(p.beamC, q.beamC, fraction);
#endif
#endif
  return p;
}

#if TETMARCH_LIT_PARTS
// p + (b - a) * fraction.
Light shiftLight(Light p, Light a, Light b, real fraction)
{
  p.diffuse = p.diffuse + (b.diffuse - a.diffuse) * fraction;
  p.specular = p.specular + (b.specular - a.specular) * fraction;
  return p;
}

Illumination shiftIllumination(Illumination p, Illumination a, Illumination b, real fraction)
{
  p.direct = shiftLight(p.direct, a.direct, b.direct, fraction);
#if TETMARCH_HEADLIGHT_SHADOWS
  p.head = shiftLight(p.head, a.head, b.head, fraction);
#endif
#if TETMARCH_SAMPLED_BEAMS
  p.beamA = shiftLight(p.beamA, a.beamA, b.beamA, fraction);
#if TETMARCH_SEVERAL_SHADOWS
  p.beamB = shiftLight(p.beamB, a.beamB, b.beamB, fraction);
  p.beamC = shiftLight(p.beamC, a.beamC, b.beamC, fraction);
#endif
#endif
  return p;
}
#endif
