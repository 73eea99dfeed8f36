# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

# The names of the gallery's pictures, for the programs and for their tests. The source file of the
# same name draws each picture. The list is empty if VTK lacks a module that they need.
set(pictures)
if (TARGET VTK::FiltersCore AND TARGET VTK::FiltersSources AND TARGET VTK::IOImage)
  set(pictures
    AddingLights
    Alpha
    Ambient
    Box
    ColouredLight
    ColoursFromData
    Crystal
    Diffuse
    Edges
    FlatAndSmooth
    Glass
    Highlights
    Lines
    Passes
    SharpEdges
    Spheres
    Textures
    Unlit)
endif ()
