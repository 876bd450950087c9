// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Warnings of a representation that has nothing to draw, once and in the terms of ParaView's
// panels. The mapper reports errors of arrays, grids and images.
#ifndef TetMarchInputProblem_h
#define TetMarchInputProblem_h

#include <string>

class vtkDataObject;
class vtkInformation;
class vtkObject;

namespace tetmarch
{

/**
 * The name in what GetInputArrayInformation() of a representation returns; null if there is none.
 */
const char* arrayOf(vtkInformation* colors);

class InputProblem
{
public:
  /**
   * Count the cells of all processes; each process with data must call it. Null if the data are in
   * other processes.
   */
  void lookAt(vtkDataObject* input);

  /**
   * A warning of the representation, unless it was the last one, in the first process with data.
   * `array` is the array used for colouring; null or empty for none.
   */
  void warn(vtkObject* representation, const char* array);

private:
  std::string textFor(const char* array) const;

  bool HasData = false;
  long long Cells = 0;  // of all processes
  long long Solids = 0; // of them, those of three dimensions; flat images count as such
  bool HasArrays = false;
  std::string Said;
};

} // namespace tetmarch

#endif
