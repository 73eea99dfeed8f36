// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief CameraFrame::toFrame() for several points at a time, for kernels
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorFrame_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorFrame_h
#undef lambent_VectorFrame_h
#else
#define lambent_VectorFrame_h
#endif

#include "CameraFrame.h"
#include "VectorDoubles.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
struct FrameVector
{
  V x, y, z, w;
};

class VectorFrame
{
public:
  explicit VectorFrame(const CameraFrame& frame)
    : Frame(frame)
  {
  }

  FrameVector toFrame(V x, V y, V z) const
  {
    const V dx = hn::Sub(x, hn::Set(d, this->Frame.eye.x));
    const V dy = hn::Sub(y, hn::Set(d, this->Frame.eye.y));
    const V dz = hn::Sub(z, hn::Set(d, this->Frame.eye.z));
    const auto along = [&](const Vec3& axis)
    {
      return hn::Add(hn::Add(hn::Mul(hn::Set(d, axis.x), dx), hn::Mul(hn::Set(d, axis.y), dy)),
        hn::Mul(hn::Set(d, axis.z), dz));
    };
    const V forward = along(this->Frame.forward);
    return { along(this->Frame.right), along(this->Frame.up), forward,
      this->Frame.parallel ? hn::Set(d, 1.0) : forward };
  }

private:
  const CameraFrame& Frame;
};
}
}
}
HWY_AFTER_NAMESPACE();
#endif
