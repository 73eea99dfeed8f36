# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

# The pictures of the gallery, for those who draw them and those who test them. Each is drawn by the
# source file of that name. None where VTK lacks what they need.
set(pictures)
if (TARGET VTK::FiltersCore AND TARGET VTK::FiltersSources AND TARGET VTK::IOImage)
  set(pictures
    AddingLights
    Ambient
    Box
    ColouredLight
    Diffuse
    FlatAndSmooth
    SharpEdges
    Spheres
    Unlit)
endif ()
