# Kernels of the CPU reference that tests alone have, below `tetmarch_generated_dir`.
set(tetmarch_generated_dir "${CMAKE_CURRENT_BINARY_DIR}/Generated")
include("${PROJECT_SOURCE_DIR}/VTKModule/Variants/Features.cmake")
include("${PROJECT_SOURCE_DIR}/VTKModule/Reference/Kernels.cmake")
include_directories("${tetmarch_generated_dir}")

tetmarch_picture_features(picture POINT_SCALARS ADAPTIVE)
tetmarch_kernel(ListKernel ${picture} ENTRY_LISTS)
# Without fused multiply-add.
set(portable ${picture})
list(REMOVE_ITEM portable HAS_FMA)
tetmarch_kernel(PortablePointKernel ${portable})
tetmarch_kernel(PortableListKernel ${portable} ENTRY_LISTS)
# Of what is visible of a mesh.
set(visible ${picture})
list(REMOVE_ITEM visible TRANSPARENT_RANGES)
tetmarch_kernel(PartKernel ${visible} ENTRY_LISTS VISIBLE_PART)
# Kernels for pictures march evenly spaced planes as rectilinear ones, and don't leap; the GPU does otherwise.
tetmarch_picture_features(uniform STRUCTURED POINT_SCALARS ADAPTIVE)
list(REMOVE_ITEM uniform RECTILINEAR)
tetmarch_kernel(UniformKernel ${uniform})
tetmarch_kernel(LeapingKernel ${uniform} LEAPS)

# Marches that find where a ray is picked.
set(picked HIDDEN_CELLS PICKED CLIPPED CROPPED)
set(picked_mesh ${picked} HAS_FMA BVH)
tetmarch_kernel(PickCellKernel ${picked_mesh} NAN_SHOWN GRADIENT_OPACITY)
tetmarch_kernel(PickPointKernel ${picked_mesh} NAN_SHOWN GRADIENT_OPACITY POINT_SCALARS)
tetmarch_kernel(PickPointGradientKernel ${picked_mesh} NAN_SHOWN GRADIENT_OPACITY POINT_SCALARS CELL_GRADIENTS)
tetmarch_kernel(PickExtremeKernel ${picked_mesh} EXTREME POINT_SCALARS)
tetmarch_kernel(PickSumKernel ${picked_mesh} SUM POINT_SCALARS)
tetmarch_kernel(PickIsosurfacesKernel ${picked_mesh} ISOSURFACES POINT_SCALARS)
tetmarch_kernel(PickTrilinearKernel ${picked} STRUCTURED RECTILINEAR NAN_SHOWN POINT_SCALARS ADAPTIVE)
