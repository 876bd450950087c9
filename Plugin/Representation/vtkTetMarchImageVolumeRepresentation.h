// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchImageVolumeRepresentation
 * @brief   ParaView's volume representation of images, drawn by vtkTetMarchSmartVolumeMapper
 *
 * For images and rectilinear grids, and trees of them. The mapper receives the input unchanged,
 * with ghosts, blanked cells and blocks, so that ids are those of the input. The superclass would
 * remove layers of ghosts, and renumber the blocks of a tree; only its properties set by XML are
 * used. ParaView's lower level of detail during interaction is the same volume, whose mapper casts
 * fewer rays. Cells of the volume can be selected in the view.
 *
 * A view mode adds its legend to the view, in the process that draws.
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
   * The drawn blocks of composite input: see tetmarch::BlockSelection.
   */
  vtkTetMarchBlocksMethodsMacro();
  //@}

  /**
   * The settings of the mapper. The default opacity law is STRUCTURED.
   */
  vtkTetMarchSettings* GetSettings() const;

  //@{
  /**
   * Forwarded to GetSettings(): see vtkTetMarchSettings.
   */
  vtkTetMarchSettingsMethodsMacro();
  //@}

  /**
   * The object by which ParaView gets the statistics of the last frame.
   */
  void SetLastFrame(vtkTetMarchLastFrame* frame);

  //@{
  /**
   * Forwarded to the mapper: see vtkTetMarchSmartVolumeMapper.
   */
  void SetAverageIPScalarRange(double low, double high);
  void SetCroppingRegionFlags(int flags);
  void SetSampleDistance(double distance);
  void SetUseJittering(bool jitters);
  //@}

  /**
   * The legend is visible only with the volume.
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
