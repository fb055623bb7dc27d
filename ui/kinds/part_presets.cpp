#include "ui/kinds/part_presets.h"

#include <QCoreApplication>

namespace ui {
namespace {

using modeling::ProfileChain;
using modeling::RevolutionShape;
using modeling::straightSegment;
using modeling::Vec2;

RevolutionShape turned(ProfileChain outside, ProfileChain inside, double cellSize) {
  RevolutionShape shape;
  shape.outside = std::move(outside);
  shape.inside = std::move(inside);
  shape.correspondence = modeling::ProfileCorrespondence::segments;
  shape.resolution.cellSize = cellSize;
  shape.resolution.counts[2] = 1;
  return shape;
}

modeling::CubicSegment<Vec2> straight(double r0, double z0, double r1, double z1) {
  return straightSegment(Vec2(r0, z0), Vec2(r1, z1));
}

modeling::CubicSegment<Vec2> curved(const Vec2& start, const Vec2& leaving, const Vec2& arriving,
                                    const Vec2& end) {
  return {start, leaving, arriving, end};
}

RevolutionShape cup() {
  return turned({straight(0, 0, 2.4, 0), curved({2.4, 0}, {3.3, 0}, {3.7, 0.6}, {3.8, 1.6}),
                 curved({3.8, 1.6}, {4.0, 3.6}, {4.0, 5.6}, {4.2, 8.0})},
                {straight(0, 0.5, 2.3, 0.5), curved({2.3, 0.5}, {2.95, 0.5}, {3.25, 0.95}, {3.32, 1.7}),
                 curved({3.32, 1.7}, {3.52, 3.8}, {3.53, 5.7}, {3.74, 8.0})},
                0.6);
}

RevolutionShape bowl() {
  return turned({straight(0, 0, 2.6, 0), curved({2.6, 0}, {5.2, 0}, {7.2, 2.2}, {7.6, 5.6})},
                {straight(0, 0.5, 2.5, 0.5), curved({2.5, 0.5}, {4.95, 0.5}, {6.75, 2.5}, {7.1, 5.65})}, 0.7);
}

RevolutionShape plate() {
  return turned({straight(0, 0, 5.5, 0), curved({5.5, 0}, {7.6, 0}, {8.4, 0.9}, {10, 1.4}),
                 straight(10, 1.4, 12.5, 2.0)},
                {straight(0, 0.5, 5.4, 0.5), curved({5.4, 0.5}, {7.4, 0.5}, {8.2, 1.4}, {9.86, 1.88}),
                 straight(9.86, 1.88, 12.38, 2.49)},
                0.8);
}

RevolutionShape vase() {
  return turned({straight(0, 0, 2.8, 0), curved({2.8, 0}, {4.3, 0}, {5.6, 3.2}, {5.6, 6.2}),
                 curved({5.6, 6.2}, {5.6, 10}, {2.2, 11}, {2.2, 14}),
                 curved({2.2, 14}, {2.2, 15.4}, {2.7, 16.2}, {3.6, 17})},
                {straight(0, 0.5, 2.7, 0.5), curved({2.7, 0.5}, {3.95, 0.5}, {5.12, 3.5}, {5.12, 6.2}),
                 curved({5.12, 6.2}, {5.12, 9.75}, {1.73, 10.8}, {1.73, 14}),
                 curved({1.73, 14}, {1.73, 15.6}, {2.32, 16.5}, {3.28, 17.35})},
                0.8);
}

RevolutionShape bottle() {
  return turned({straight(0, 0, 2.9, 0), curved({2.9, 0}, {3.5, 0}, {3.9, 0.4}, {3.9, 1.1}),
                 straight(3.9, 1.1, 3.9, 10), curved({3.9, 10}, {3.9, 13.4}, {1.6, 13.2}, {1.6, 16.5}),
                 straight(1.6, 16.5, 1.6, 21)},
                {straight(0, 0.5, 2.8, 0.5), curved({2.8, 0.5}, {3.2, 0.5}, {3.42, 0.8}, {3.42, 1.2}),
                 straight(3.42, 1.2, 3.42, 10), curved({3.42, 10}, {3.42, 13.1}, {1.12, 13}, {1.12, 16.5}),
                 straight(1.12, 16.5, 1.12, 21)},
                0.75);
}

/// Newell's teapot in centimetres, seven tenths as wide as the one in the scenes.
RevolutionShape teapotBody() {
  return turned(
      {curved({0, 0}, {4.75, 0}, {5, 0.25}, {5, 0.5}), curved({5, 0.5}, {5, 0.75}, {6.66, 1.5}, {6.66, 3}),
       curved({6.66, 3}, {6.66, 4.5}, {5.83, 6.25}, {5, 8})},
      {curved({0, 0.4}, {4.5, 0.4}, {4.57, 0.6}, {4.65, 0.75}),
       curved({4.65, 0.75}, {4.8, 1.05}, {6.24, 1.7}, {6.24, 3}),
       curved({6.24, 3}, {6.24, 4.4}, {5.44, 6.1}, {4.62, 7.82})},
      0.7);
}

}  // namespace

QString nameOf(ProfilePreset preset) {
  switch (preset) {
    case ProfilePreset::cup:
      return QCoreApplication::translate("part presets", "Cup");
    case ProfilePreset::bowl:
      return QCoreApplication::translate("part presets", "Bowl");
    case ProfilePreset::plate:
      return QCoreApplication::translate("part presets", "Plate");
    case ProfilePreset::vase:
      return QCoreApplication::translate("part presets", "Vase");
    case ProfilePreset::bottle:
      return QCoreApplication::translate("part presets", "Bottle");
    case ProfilePreset::teapotBody:
      return QCoreApplication::translate("part presets", "Teapot body");
  }
  return {};
}

const char* nameInScene(ProfilePreset preset) {
  switch (preset) {
    case ProfilePreset::cup:
      return "cup";
    case ProfilePreset::bowl:
      return "bowl";
    case ProfilePreset::plate:
      return "plate";
    case ProfilePreset::vase:
      return "vase";
    case ProfilePreset::bottle:
      return "bottle";
    case ProfilePreset::teapotBody:
      return "teapot";
  }
  return "dish";
}

modeling::RevolutionShape shapeOf(ProfilePreset preset) {
  switch (preset) {
    case ProfilePreset::cup:
      return cup();
    case ProfilePreset::bowl:
      return bowl();
    case ProfilePreset::plate:
      return plate();
    case ProfilePreset::vase:
      return vase();
    case ProfilePreset::bottle:
      return bottle();
    case ProfilePreset::teapotBody:
      return teapotBody();
  }
  return {};
}

}  // namespace ui
