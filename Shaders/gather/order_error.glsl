// The error of integrating a subsegment as if colour and extinction were distributed evenly in it.
//
// The optical depth D of the subsegment is exact, only the order of the colours in it is lost. With u the optical depth
// from its front, the exact colour is the integral of C(u) exp(-u), the other one that of C(u) phi with
// phi = (1 - exp(-D)) / D. Integrated by parts, the difference is that of H(u) dC(u) with
// H(u) = 1 - exp(-u) - phi u, which lies between 0 and its value where exp(-u) = phi:
//   0 <= H <= 1 - phi + phi ln(phi) = D^2 / 8 - D^3 / 16 + ...
// So the error of a channel is at most this times the total variation of the colour in the subsegment, given by a
// table.

// At least 1 - phi + phi ln(phi), by at most 4 % for D < 10; without cancellation, and 1 for infinite depth.
real orderErrorFactor(real depth)
{
  real d = min(depth, real(1e18));
  real square = d * d;
  return square / (square + real(3.7) * d + real(8));
}
