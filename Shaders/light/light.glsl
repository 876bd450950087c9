// What light makes of the volume at a point: its own colour is multiplied, and highlights are added.

struct Light
{
  vec3 diffuse;  // factor of the volume's own colour
  vec3 specular; // is added to it
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

Light mixLight(Light p, Light q, real share)
{
  p.diffuse = p.diffuse + (q.diffuse - p.diffuse) * share;
  p.specular = p.specular + (q.specular - p.specular) * share;
  return p;
}

// The light at a point, by the way it has come.
struct Illumination
{
  Light direct; // all that is known
#if TETMARCH_HEADLIGHT_SHADOWS
  Light head; // along the ray, before it was absorbed on its way: as much as comes back
#endif
#if TETMARCH_SAMPLED_SHADOWS
  Light beamA; // from each light that casts shadows, before it was absorbed on its way; an array would be looked up
#if TETMARCH_SEVERAL_SHADOWS
  Light beamB; // lane by lane on a software renderer
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
#if TETMARCH_SAMPLED_SHADOWS
  lit.beamA = noLight();
#if TETMARCH_SEVERAL_SHADOWS
  lit.beamB = noLight();
  lit.beamC = noLight();
#endif
#endif
  return lit;
}

Illumination mixIllumination(Illumination p, Illumination q, real share)
{
  p.direct = mixLight(p.direct, q.direct, share);
#if TETMARCH_HEADLIGHT_SHADOWS
  p.head = mixLight(p.head, q.head, share);
#endif
#if TETMARCH_SAMPLED_SHADOWS
  p.beamA = mixLight(p.beamA, q.beamA, share);
#if TETMARCH_SEVERAL_SHADOWS
  p.beamB = mixLight(p.beamB, q.beamB, share);
  p.beamC = mixLight(p.beamC, q.beamC, share);
#endif
#endif
  return p;
}
