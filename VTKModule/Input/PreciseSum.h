// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Sums of products as in twice the precision of double (Dot2 in Ogita, Rump and Oishi, "Accurate
// sum and dot product", 2005).
#ifndef TetMarchInputPreciseSum_h
#define TetMarchInputPreciseSum_h

#include <cmath>

namespace tetmarch
{

class PreciseSum
{
public:
  void add(double x)
  {
    const double sum = this->Sum + x;
    const double part = sum - this->Sum;
    this->Rest += (this->Sum - (sum - part)) + (x - part);
    this->Sum = sum;
  }
  void addProduct(double a, double b)
  {
    const double product = a * b;
    this->Rest += std::fma(a, b, -product);
    this->add(product);
  }
  double value() const { return this->Sum + this->Rest; }

private:
  double Sum = 0;
  double Rest = 0; // the accumulated rounding errors of the sum
};

} // namespace tetmarch

#endif
