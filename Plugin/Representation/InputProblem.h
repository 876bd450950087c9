// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Why a representation has nothing to draw, said once and in the words of ParaView's panels. What
// is wrong with an array, a grid or an image is said by the mapper.
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
   * Look for cells, in the data of all processes; each that has data has to call it. Null where the
   * data is in other processes.
   */
  void lookAt(vtkDataObject* input);

  /**
   * A warning of the representation, if it wasn't the last one, in the first process of those that
   * have data. `array` is the one that the data is coloured by; null or empty for none.
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
