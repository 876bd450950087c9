// Direction k of n, evenly distributed over the sphere: a Fibonacci lattice (Swinbank and Purser 2006), the same for
// all vertices.
vec3 sphereDirection(int k, int n)
{
  real z = real(1) - real(2 * k + 1) / real(n);
  real r = sqrt(max(real(1) - z * z, real(0)));
  real turn = real(k) * real(2.3999632297286533); // the golden angle
  return vec3(r * cos(turn), r * sin(turn), z);
}
