// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchImageVolumeRepresentation
 * @brief   ParaView's volume representation of images, drawn by vtkTetMarchSmartVolumeMapper
 *
 * For images and rectilinear grids, and trees of them. The mapper gets the input as it is: with its
 * ghosts, its blanked cells and its blocks, so that ids are those of the input. The superclass
 * would cut off layers of ghosts, and list the blocks of a tree anew; of it, what its XML sets is
 * left. Where ParaView draws a lower level of detail while somebody interacts, that is the same
 * volume: its mapper takes fewer rays then. Cells of the volume can be selected in the view.
 *
 * A view mode brings its legend into the view, in the process that draws.
 *
 * @sa vtkTetMarchVolumeRepresentation
 */
#ifndef vtkTetMarchImageVolumeRepresentation_h
#define vtkTetMarchImageVolumeRepresentation_h

#include "InputProblem.h"   // For InputProblem
#include "SelectedBlocks.h" // For the selection of blocks
#include "vtkBoundingBox.h" // For WholeBounds
#include "vtkImageVolumeRepresentation.h"
#include "vtkTetMarchRepresentationMacros.h" // For methods of both representations
#include "vtkTetMarchRepresentationModule.h" // For export macro

class vtkTetMarchLastFrame;
class vtkTetMarchLegend;
class vtkTetMarchSmartVolumeMapper;

class VTKTETMARCHREPRESENTATION_EXPORT vtkTetMarchImageVolumeRepresentation
  : public vtkImageVolumeRepresentation
{
public:
  static vtkTetMarchImageVolumeRepresentation* New();
  vtkTypeMacro(vtkTetMarchImageVolumeRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* type, vtkInformation* inInfo, vtkInformation* outInfo) override;

  //@{
  /**
   * Which blocks are drawn of composite input: see tetmarch::BlockSelection.
   */
  vtkTetMarchBlocksMethodsMacro();
  //@}

  /**
   * How the volume is drawn: the settings of its mapper. The opacity law begins as STRUCTURED.
   */
  vtkTetMarchSettings* GetSettings() const;

  //@{
  /**
   * The method of that name of GetSettings(): see vtkTetMarchSettings.
   */
  vtkTetMarchSettingsMethodsMacro();
  //@}

  /**
   * By this object ParaView asks for what the mapper says of the last frame.
   */
  void SetLastFrame(vtkTetMarchLastFrame* frame);

  //@{
  /**
   * The method of that name of the mapper: see vtkTetMarchSmartVolumeMapper.
   */
  void SetAverageIPScalarRange(double low, double high);
  void SetCroppingRegionFlags(int flags);
  void SetSampleDistance(double distance);
  void SetUseJittering(bool jitters);
  //@}

  /**
   * The legend is seen with the volume only.
   */
  void SetVisibility(bool visible) override;

protected:
  vtkTetMarchImageVolumeRepresentation();
  ~vtkTetMarchImageVolumeRepresentation() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void UpdateMapperParameters() override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkTetMarchImageVolumeRepresentation(const vtkTetMarchImageVolumeRepresentation&) = delete;
  void operator=(const vtkTetMarchImageVolumeRepresentation&) = delete;

  vtkBoundingBox WholeBounds; // of the data of all processes
  tetmarch::BlockSelection Blocks;
  tetmarch::InputProblem InputProblem;
  vtkNew<vtkTetMarchSmartVolumeMapper> TetMarchMapper;
  vtkNew<vtkTetMarchLegend> Legend;
};

#endif
