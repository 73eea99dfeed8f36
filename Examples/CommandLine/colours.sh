# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

# What does the file hold?
lambent engine.vtp --list

# Its temperatures, on a logarithmic scale
lambent engine.vtp -o temperature.png --color-by temperature --colormap viridis --log --range 20,1500

# The speed: the magnitude of a vector
lambent engine.vtp -o flow.png --color-by velocity:magnitude --colormap coolwarm --nan-color gray

# Its points as spheres, whose radii come from another array
lambent engine.vtp -o points.png --spheres radius --color-by temperature --colormap inferno
