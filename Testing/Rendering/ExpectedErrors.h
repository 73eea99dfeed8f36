// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief expect an error, an empty output, and the right picture afterwards
 */
#ifndef ExpectedErrors_h
#define ExpectedErrors_h

#include "Meshes.h"
#include "Messages.h"

#include <functional>

using Change = std::function<void(Studio&)>;

/// Renders a picture, calls `spoil`, which makes a setting invalid, and expects an error with these
/// parts. Then calls `mend`, which restores the setting, and expects the same picture.
inline void expectError(
  const Change& spoil, const std::vector<std::string>& parts, const Change& mend)
{
  SCOPED_TRACE(parts.front());
  Studio studio;
  Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeSphere(6));
  const Picture expected = render(studio.tracer);
  spoil(studio);
  studio.tracer->Update();
  expectMessage(messages.errors(), parts);
  EXPECT_TRUE(messages.warnings().empty());
  EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(studio.tracer->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  mend(studio);
  messages.clear();
  const Picture again = render(studio.tracer);
  EXPECT_SAME_BITS(expected, again);
  EXPECT_EQ(messages.errors(), std::vector<std::string>());
  EXPECT_EQ(messages.executive(), std::vector<std::string>());
}

#endif
