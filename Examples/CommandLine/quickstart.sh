# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

lambent Data/seashell.vtp -o seashell.png --size 960x540 \
  --camera-position 0,0,7.25 --focal-point 0,0,0 --diffuse 0.95 --ambient 0.05 --feature-angle 180 \
  --light 'direction=5,-6,-7;color=1,0.7,0.4' \
  --light 'direction=-7,1,-2.5;color=0.2,0.4,1'
