// SPDX-License-Identifier: BSD-3-Clause
// The window of GLFW: its callbacks, called as GLFW calls them, must reach the viewer.
#include "Failure.h"
#include "GlfwWindow.h"
#include "ViewerTesting.h"

#include "vtkGenericOpenGLRenderWindow.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <memory>

namespace skyline
{
namespace testing
{
namespace
{

class GlfwWindowTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    PrepareVtk(Silent());
    try
    {
      this->Window = std::make_unique<GlfwWindow>(Width, Height);
    }
    catch (const Failure& reason)
    {
      GTEST_SKIP() << reason.what();
    }
    this->View = std::make_unique<Viewer>(this->Window->GetRenderWindow(), Quick(), Silent());
    this->Window->Connect(*this->View);
    ASSERT_TRUE(Settle(*this->View, this->Now));
  }

  void TearDown() override
  {
    if (this->Window)
    {
      this->Window->Disconnect();
    }
    this->View.reset();
    this->Window.reset();
  }

  // GLFW returns a callback when another one is set.
  template <typename Callback>
  Callback Take(Callback (*set)(GLFWwindow*, Callback))
  {
    const Callback callback = set(this->Window->GetHandle(), nullptr);
    set(this->Window->GetHandle(), callback);
    return callback;
  }

  void Key(int key, int bits = 0)
  {
    const auto press = this->Take(glfwSetKeyCallback);
    press(this->Window->GetHandle(), key, 0, GLFW_PRESS, bits);
    press(this->Window->GetHandle(), key, 0, GLFW_RELEASE, bits);
  }

  std::unique_ptr<GlfwWindow> Window;
  std::unique_ptr<Viewer> View;
  double Now = 0.0;
};

TEST_F(GlfwWindowTest, ShowsTheTerrain)
{
  EXPECT_GT(Brightness(this->Window->GetRenderWindow()), 30.0);
  EXPECT_EQ(this->View->GetLayout().FontSize, 14) << "a screen of 96 dots an inch";
}

TEST_F(GlfwWindowTest, KeysReachTheState)
{
  const double minutes = this->View->GetState().Clock.GetMinutes();
  this->Key(GLFW_KEY_RIGHT);
  EXPECT_EQ(this->View->GetState().Clock.GetMinutes(), minutes + 10.0);
  this->Key(GLFW_KEY_LEFT, GLFW_MOD_SHIFT);
  EXPECT_EQ(this->View->GetState().Clock.GetMinutes(), minutes + 9.0);
  this->Key(GLFW_KEY_H);
  EXPECT_TRUE(this->View->GetState().Help);
  this->Key(GLFW_KEY_ESCAPE);
  EXPECT_FALSE(this->View->GetState().Help);
  this->Key(GLFW_KEY_KP_ADD);
  EXPECT_GT(this->View->GetState().Exposure, 0.0);
  this->Key(GLFW_KEY_F5);
  EXPECT_FALSE(this->View->WantsToLeave());
  this->Key(GLFW_KEY_Q);
  EXPECT_TRUE(this->View->WantsToLeave());
}

TEST_F(GlfwWindowTest, MouseComesFromTheTop)
{
  GLFWwindow* handle = this->Window->GetHandle();
  const HudBox& box = this->View->GetLayout().Sliders[0];
  const double x = box.X + 0.5 * box.Width;
  const double y = Height - 1.0 - (box.Y + 0.5 * box.Height);
  glfwSetCursorPos(handle, x, y);
  glfwPollEvents();
  this->Take(glfwSetCursorPosCallback)(handle, x, y);
  const auto button = this->Take(glfwSetMouseButtonCallback);
  double cursor[2];
  glfwGetCursorPos(handle, &cursor[0], &cursor[1]);
  if (std::abs(cursor[0] - x) > 1.0 || std::abs(cursor[1] - y) > 1.0)
  {
    GTEST_SKIP() << "the display does not let the pointer be set";
  }
  button(handle, GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS, 0);
  EXPECT_NEAR(this->View->GetState().Clock.GetMinutes(), 720.0, 1440.0 / box.Width);
  this->Take(glfwSetCursorPosCallback)(handle, x + 0.25 * box.Width, y);
  EXPECT_NEAR(this->View->GetState().Clock.GetMinutes(), 1080.0, 1440.0 / box.Width);
  button(handle, GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE, 0);
  button(handle, GLFW_MOUSE_BUTTON_4, GLFW_PRESS, 0); // has no function
  this->Take(glfwSetScrollCallback)(handle, 0.0, 1.0);
  EXPECT_TRUE(this->View->Draw(this->Now += 1.0));
}

TEST_F(GlfwWindowTest, DropsReachTheViewer)
{
  const std::string map = Data("light-maps/sky_128.hdr");
  const char* files[] = { map.c_str(), "/nowhere.tif" };
  this->Take(glfwSetDropCallback)(this->Window->GetHandle(), 2, files);
  EXPECT_EQ(this->View->GetState().GetSky().Text, map);
  EXPECT_NE(this->View->GetMessage().find("/nowhere.tif"), std::string::npos);
}

TEST_F(GlfwWindowTest, ResizesAndMinimises)
{
  GLFWwindow* handle = this->Window->GetHandle();
  glfwSetWindowSize(handle, 500, 300);
  for (int k = 0; k < 100 && this->Window->GetRenderWindow()->GetSize()[0] != 500; ++k)
  {
    glfwWaitEventsTimeout(0.05);
  }
  EXPECT_EQ(this->Window->GetRenderWindow()->GetSize()[0], 500);
  EXPECT_EQ(this->Window->GetRenderWindow()->GetSize()[1], 300);
  ASSERT_TRUE(Settle(*this->View, this->Now));
  EXPECT_GT(Brightness(this->Window->GetRenderWindow()), 30.0);
  this->Take(glfwSetWindowIconifyCallback)(handle, GLFW_TRUE);
  EXPECT_LT(this->View->GetPatience(this->Now), 0.0);
  this->Take(glfwSetWindowIconifyCallback)(handle, GLFW_FALSE);
  this->Take(glfwSetWindowRefreshCallback)(handle);
  EXPECT_EQ(this->View->GetPatience(this->Now), 0.0);
}

} // namespace
} // namespace testing
} // namespace skyline
