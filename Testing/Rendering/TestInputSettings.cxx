// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The property of an input stays with its connection when other connections change.
#include "Meshes.h"
#include "Messages.h"

#include "vtkSphereSource.h"

namespace
{
/// A ray tracer with four connections, each with a property of its own.
struct Four
{
  vtkNew<vtkLambentRayTracer> tracer;
  std::vector<vtkSmartPointer<vtkSphereSource>> sources;
  std::vector<vtkSmartPointer<vtkProperty>> properties;

  Four()
  {
    for (int k = 0; k < 4; ++k)
    {
      this->sources.push_back(vtkSmartPointer<vtkSphereSource>::New());
      this->properties.push_back(vtkSmartPointer<vtkProperty>::New());
      this->tracer->AddInputConnection(this->sources[k]->GetOutputPort());
      this->tracer->SetInputProperty(k, this->properties[k]);
    }
  }

  /// For each connection, the number of its property in `properties`, or - for none.
  std::string found() const
  {
    std::string text;
    for (int k = 0; k < 6; ++k)
    {
      const auto at = std::find(
        this->properties.begin(), this->properties.end(), this->tracer->GetInputProperty(k));
      text += at == this->properties.end() ? "-" : std::to_string(at - this->properties.begin());
    }
    return text;
  }
};
}

TEST(InputSettings, FollowWhenAConnectionIsRemovedByItsNumber)
{
  Four four;
  const vtkMTimeType before = four.tracer->GetMTime();
  four.tracer->RemoveInputConnection(0, 1);
  EXPECT_EQ(four.found(), "023---");
  EXPECT_GT(four.tracer->GetMTime(), before);
  four.tracer->RemoveInputConnection(0, 2);
  EXPECT_EQ(four.found(), "02----");
  four.tracer->RemoveInputConnection(0, 0);
  EXPECT_EQ(four.found(), "2-----");
  four.tracer->RemoveInputConnection(0, 7); // no such connection
  EXPECT_EQ(four.found(), "2-----");
  four.tracer->AddInputConnection(four.sources[0]->GetOutputPort());
  EXPECT_EQ(four.found(), "2-----");
}

TEST(InputSettings, FollowWhenAConnectionIsRemovedByItsOutput)
{
  Four four;
  four.tracer->RemoveInputConnection(0, four.sources[2]->GetOutputPort());
  EXPECT_EQ(four.found(), "013---");
  four.tracer->RemoveInputConnection(0, four.sources[0]->GetOutputPort());
  EXPECT_EQ(four.found(), "13----");
  four.tracer->RemoveInputConnection(0, four.sources[0]->GetOutputPort()); // already removed
  EXPECT_EQ(four.found(), "13----");
}

// If an output is connected twice, the property of the connection that was named is removed.
TEST(InputSettings, FollowAmongConnectionsOfOneSource)
{
  for (int removed : { 3, 4 })
  {
    Four four;
    four.tracer->AddInputConnection(four.sources[3]->GetOutputPort());
    four.tracer->SetInputProperty(4, four.properties[0]);
    four.tracer->RemoveInputConnection(0, removed);
    EXPECT_EQ(four.tracer->GetNumberOfInputConnections(0), 4);
    EXPECT_EQ(four.found(), removed == 3 ? "0120--" : "0123--");
  }
}

// The next meshes take the places of the previous ones.
TEST(InputSettings, StayWithTheirNumbersWhenAllConnectionsAreRemoved)
{
  Four four;
  four.tracer->RemoveAllInputs();
  EXPECT_EQ(four.found(), "0123--");
  Four other;
  other.tracer->RemoveAllInputConnections(0);
  EXPECT_EQ(other.found(), "0123--");
  other.tracer->AddInputConnection(other.sources[3]->GetOutputPort());
  EXPECT_EQ(other.found(), "0123--");
}

TEST(InputSettings, StayWhenTheSameConnectionsAreMadeAgain)
{
  Four four;
  four.tracer->SetInputConnection(four.sources[0]->GetOutputPort());
  four.tracer->AddInputConnection(four.sources[1]->GetOutputPort());
  EXPECT_EQ(four.found(), "0123--");
}

TEST(InputSettings, FollowOrStayWhenAnotherConnectionReplacesAll)
{
  Four four;
  four.tracer->SetInputConnection(four.sources[2]->GetOutputPort()); // one of the four
  EXPECT_EQ(four.found(), "2-----");
  four.tracer->SetInputConnection(four.sources[2]->GetOutputPort());
  EXPECT_EQ(four.found(), "2-----");
  four.tracer->SetInputConnection(0, four.sources[1]->GetOutputPort()); // another one
  EXPECT_EQ(four.found(), "2-----");
  four.tracer->SetInputProperty(0, four.properties[3]);
  four.tracer->SetInputData(makeSquare());
  EXPECT_EQ(four.found(), "3-----");
  four.tracer->SetInputConnection(nullptr);
  EXPECT_EQ(four.tracer->GetNumberOfInputConnections(0), 0);
}

TEST(InputSettings, CanPrecedeTheConnection)
{
  Four four;
  vtkNew<vtkLambentRayTracer> tracer;
  for (int k = 0; k < 3; ++k)
  {
    tracer->SetInputProperty(k, four.properties[k]);
  }
  tracer->SetInputConnection(four.sources[0]->GetOutputPort());
  tracer->AddInputConnection(four.sources[1]->GetOutputPort());
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(tracer->GetInputProperty(k), four.properties[k]);
  }
  tracer->RemoveInputConnection(0, 0); // the setting of the next connection moves up
  EXPECT_EQ(tracer->GetInputProperty(0), four.properties[1]);
  EXPECT_EQ(tracer->GetInputProperty(1), four.properties[2]);
  EXPECT_EQ(tracer->GetInputProperty(2), nullptr);
}

// A property that was removed with its connection is neither kept alive nor used.
TEST(InputSettings, AreReleased)
{
  Four four;
  EXPECT_EQ(four.properties[1]->GetReferenceCount(), 2);
  four.tracer->RemoveInputConnection(0, 1);
  EXPECT_EQ(four.properties[1]->GetReferenceCount(), 1);
  const vtkMTimeType before = four.tracer->GetMTime();
  four.properties[1]->SetAmbient(0.5);
  EXPECT_EQ(four.tracer->GetMTime(), before);
  four.properties[3]->SetAmbient(0.5);
  EXPECT_GT(four.tracer->GetMTime(), before);
}

TEST(InputSettings, ApplyToTheRemainingInput)
{
  Studio studio;
  vtkNew<vtkProperty> red, blue;
  red->LightingOff();
  red->SetColor(1.0, 0.0, 0.0);
  blue->LightingOff();
  blue->SetColor(0.0, 0.0, 1.0);
  studio.tracer->AddInputDataObject(makeSquare());
  studio.tracer->AddInputDataObject(makeSphere(6));
  studio.tracer->SetInputProperty(0, red);
  studio.tracer->SetInputProperty(1, blue);
  render(studio.tracer);
  studio.tracer->RemoveInputConnection(0, 0);
  const Picture picture = render(studio.tracer);
  EXPECT_EQ(picture.count({ 1.0, 0.0, 0.0 }), 0);
  EXPECT_GT(picture.count({ 0.0, 0.0, 1.0 }), 0);
}
