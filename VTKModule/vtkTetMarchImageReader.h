// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchImageReader
 * @brief   Reads NRRD (.nrrd, .nhdr) and MetaImage (.mha, .mhd) files
 *
 * Unlike vtkNrrdReader and vtkMetaImageReader it keeps the directions of axes, reads values in text
 * form, and checks a header against the length of the files before it allocates memory. An
 * inconsistent file is reported by one error.
 *
 * Values keep their type. A NRRD axis that is not spatial (by `space directions` or `kinds`; the
 * first of four if there are neither) contains components, which must be adjacent in memory. Images
 * of up to three axes are read. All encodings of NRRD except bzip2 are read. Detached data may be
 * in one file, a list of files, or files numbered by a pattern.
 */
#ifndef vtkTetMarchImageReader_h
#define vtkTetMarchImageReader_h

#include "vtkImageAlgorithm.h"
#include "vtkRenderingTetMarchModule.h" // For export macro

#include <memory> // For the header

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchImageReader : public vtkImageAlgorithm
{
public:
  static vtkTetMarchImageReader* New();
  vtkTypeMacro(vtkTetMarchImageReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The file with the header. The extension determines its format.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

protected:
  vtkTetMarchImageReader();
  ~vtkTetMarchImageReader() override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTetMarchImageReader(const vtkTetMarchImageReader&) = delete;
  void operator=(const vtkTetMarchImageReader&) = delete;

  void Refuse(const std::string& reason);

  char* FileName = nullptr;
  struct Found;
  std::unique_ptr<Found> Header;
};

#endif
