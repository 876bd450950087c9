// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchFirstPicture
 * @brief   What to draw of data that nobody has seen yet, and how
 *
 * From the data alone it chooses an array, transfer functions, a unit distance and a camera, so
 * that a first picture shows the data and is neither empty nor a slab. It needs no OpenGL and no
 * window; its methods can be called in a thread of their own. The same data give the same choice.
 * It takes an unstructured grid, an image, a rectilinear or curvilinear grid, or a tree of such
 * blocks.
 *
 * @code{.cpp}
 * vtkNew<vtkTetMarchFirstPicture> first;
 * first->SetInputData(grid);
 * if (first->Choose())
 * {
 *   first->ApplyTo(volume); // its property; the array and the component of its mapper
 *   first->PlaceCamera(renderer->GetActiveCamera(), 16.0 / 9.0);
 * }
 * @endcode
 *
 * Array: of several blocks, arrays that all of them have come first. Of these, physical values come
 * before numbers of cells, blocks or materials, these before arrays whose values are all equal;
 * points come before cells, one component before several, of which the magnitude is drawn.
 *
 * Range: the 2nd to the 98th percentile. Background: the peak of the histogram if there is one,
 * else the low end of the range. Opacity: 0 at the background of images, nearly 0 at that of
 * meshes; from there to the ends of the range it rises with a power of the distance. Unit distance:
 * half of the pixels that show anything are more than half opaque, and not more than one in 20 of
 * them above 0.97. Power: from 0.5 to 2 the one whose picture shows most, for its opacities have
 * the greatest entropy.
 *
 * Every method that returns a bool returns false after an error, which says what is wrong.
 */
#ifndef vtkTetMarchFirstPicture_h
#define vtkTetMarchFirstPicture_h

#include "vtkObject.h"
#include "vtkRenderingTetMarchModule.h" // For export macro

#include <memory> // For what is found of the data
#include <string> // For names

class vtkCamera;
class vtkColorTransferFunction;
class vtkDataArray;
class vtkDataObject;
class vtkPiecewiseFunction;
class vtkStringArray;
class vtkTable;
class vtkVolume;

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchFirstPicture : public vtkObject
{
public:
  static vtkTetMarchFirstPicture* New();
  vtkTypeMacro(vtkTetMarchFirstPicture, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Associations
  {
    ANY = -1,
    POINTS = 0, // as vtkDataObject::FIELD_ASSOCIATION_POINTS
    CELLS = 1   // as vtkDataObject::FIELD_ASSOCIATION_CELLS
  };

  enum OpacityLaws
  {
    OF_THE_DATA = -1,
    UNSTRUCTURED = 0, // as vtkTetMarchSettings::UNSTRUCTURED
    STRUCTURED = 1    // as vtkTetMarchSettings::STRUCTURED
  };

  //@{
  /**
   * The data; null by default. What was chosen is forgotten if it is other data than before, or if
   * it was modified.
   */
  void SetInputData(vtkDataObject* data);
  vtkDataObject* GetInputData();
  //@}

  /**
   * Whether the data can be read: cells name points that are there, coordinates are finite, arrays
   * are as long as dimensions say, and so on. All methods that read the data ask this first. The
   * error is the mapper's, and of a tree that of the first block with one. What was found out is
   * kept until the data is modified.
   */
  bool CheckData();

  /**
   * All that is wrong with the data, one fault a value: of each block its points and cells, and
   * each array that has not one tuple for each point or cell. No fault: no value.
   */
  bool ListFaults(vtkStringArray* faults);

  //@{
  /**
   * The array wished for. Empty, by default, leaves the choice.
   */
  void SetArrayName(const std::string& name);
  std::string GetArrayName() const;
  //@}

  //@{
  /**
   * Where to look for it: POINTS, CELLS or ANY, which is the default: points, then cells; but
   * cells, if all blocks have it there and some lack it on points.
   */
  vtkSetClampMacro(ArrayAssociation, int, ANY, CELLS);
  vtkGetMacro(ArrayAssociation, int);
  //@}

  //@{
  /**
   * The component wished for, from 0; -1: the magnitude; -2, the default: of an array that was
   * asked for by its name the first, else the magnitude.
   */
  vtkSetClampMacro(Component, int, -2, VTK_INT_MAX);
  vtkGetMacro(Component, int);
  //@}

  //@{
  /**
   * The range wished for, in the array's unit. The default, (1, 0), or any whose first number isn't
   * below the second, leaves the choice.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  //@}

  //@{
  /**
   * What an opacity means, see vtkTetMarchSettings::SetOpacityLaw. OF_THE_DATA, the default:
   * STRUCTURED for images and rectilinear grids, UNSTRUCTURED for all others.
   */
  vtkSetClampMacro(OpacityLaw, int, OF_THE_DATA, STRUCTURED);
  vtkGetMacro(OpacityLaw, int);
  //@}

  //@{
  /**
   * Choose the array; transfer functions and unit distance; or both. An array is chosen first if
   * none was.
   */
  bool ChooseArray();
  bool ChooseTransferFunctions();
  bool Choose();
  //@}

  /**
   * Choose the unit distance alone, for an opacity function of others.
   */
  bool ChooseUnitDistance(vtkPiecewiseFunction* opacity);

  //@{
  /**
   * The array that was chosen, of the first block that has it, or null; POINTS or CELLS; its
   * component, -1: the magnitude; its range over all blocks, (1, 0) if no value is finite.
   */
  vtkDataArray* GetChosenArray();
  int GetChosenAssociation() const;
  int GetChosenComponent() const;
  void GetDataRange(double range[2]) VTK_SIZEHINT(2);
  //@}

  //@{
  /**
   * What was chosen: the range of values that is shown, and the value that is clear.
   */
  vtkGetVector2Macro(ChosenRange, double);
  vtkGetMacro(Background, double);
  //@}

  //@{
  /**
   * What was chosen, and what ApplyTo() gives. The functions are this object's own; they can be
   * changed, and change with the next choice. The unit distance, above 0, is in units of the data's
   * coordinates.
   */
  vtkColorTransferFunction* GetColor();
  vtkPiecewiseFunction* GetOpacity();
  vtkSetClampMacro(UnitDistance, double, 1e-300, VTK_DOUBLE_MAX);
  vtkGetMacro(UnitDistance, double);
  //@}

  /**
   * What was chosen, in one line: "temperature on points, 293.1 to 913.2".
   */
  std::string Describe();

  /**
   * All arrays that can be drawn, one a row: name, association ("points", "cells"), type,
   * components, minimum and maximum (of the magnitude if there are several components; NaN if no
   * value is finite), and kind ("values", "numbers" of cells, blocks or the like, "constant", or
   * "not finite"). Arrays that have not one tuple for each point or cell are left out: see
   * ListFaults().
   */
  bool ListArrays(vtkTable* arrays);

  /**
   * Give a volume what was chosen: colour, opacity and unit distance of its property; array and
   * component of its mapper, if it has one; the opacity law, if it is one of ours.
   */
  bool ApplyTo(vtkVolume* volume);

  //@{
  /**
   * Look at the data from where its silhouette just fits into a picture of that width / height, in
   * perspective and in parallel projection: obliquely, z up; what is flat from its broad side. Of
   * images and rectilinear grids, that are clear in most places, what is shown fits into the
   * picture if transfer functions were chosen; all of their box if FitWholeData is on (off by
   * default).
   */
  bool PlaceCamera(vtkCamera* camera, double aspect);
  vtkSetMacro(FitWholeData, bool);
  vtkGetMacro(FitWholeData, bool);
  vtkBooleanMacro(FitWholeData, bool);
  //@}

protected:
  vtkTetMarchFirstPicture();
  ~vtkTetMarchFirstPicture() override;

private:
  vtkTetMarchFirstPicture(const vtkTetMarchFirstPicture&) = delete;
  void operator=(const vtkTetMarchFirstPicture&) = delete;

  struct Internals;

  bool CheckInput();
  bool CheckChosenArray();
  bool FindCrossings();
  bool UsesStructuredLaw() const;

  std::string ArrayName;
  int ArrayAssociation = ANY;
  int Component = -2;
  double Range[2] = { 1.0, 0.0 };
  int OpacityLaw = OF_THE_DATA;
  bool FitWholeData = false;
  double ChosenRange[2] = { 0.0, 1.0 };
  double Background = 0.0;
  double UnitDistance = 1.0;
  std::unique_ptr<Internals> Found;
};

#endif
