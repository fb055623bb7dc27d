#pragma once

#include <string>

/// Scene texts that several tests start from.
namespace tests {

/// Small and complete: what is left out has its default.
inline const std::string kPlainScene = R"({
  "smithereens": 1,
  "materials": {"clay": {"youngsModulus": 1e8}},
  "parts": [
    {"name": "brick", "kind": "slab", "material": "clay", "size": [4, 2, 2]}
  ]
}
)";

/// Every key of the format, with a value that is not its default.
inline const std::string kFullScene = R"({
  "smithereens": 1,
  "name": "everything",
  "materials": {
    "clay": {
      "pattern": "fig1", "youngsModulus": 1e8, "density": 1.9, "lossFactor": 0.1,
      "threshold": {"mean": 0.002, "spread": 0.25}, "plastic": {"yieldStrain": 0.01, "rate": 50},
      "look": {"outside": [0.7, 0.3, 0.2], "inside": [0.8, 0.5, 0.4], "glaze": 0.1, "finish": "matte"}, "source": "a test"
    },
    "glass": {"strength": 5e8},
    "tile": {"fractureToughness": 1e8}
  },
  "parts": [
    {"name": "brick", "kind": "slab", "material": "clay", "size": [4, 2, 2],
     "resolution": {"cellSize": 0.75, "counts": [4, null, 2]},
     "worldFromPart": {"position": [1, -2, 30.5], "rotation": [90, 0, 45], "scale": [1, 2, 0.5]},
     "velocity": [0, 0, -100], "angularVelocity": [0, 6.25, 0],
     "hold": [{"min": [-9, -9, -9], "max": [9, 9, 0.1]}]},
    {"name": "leaf", "kind": "patch", "material": "glass",
     "net": [[[0, 0, 0], [0, 1, 0], [0, 2, 0], [0, 3, 0]], [[1, 0, 1], [1, 1, 1], [1, 2, 1], [1, 3, 1]],
             [[2, 0, 1], [2, 1, 1], [2, 2, 1], [2, 3, 1]], [[3, 0, 0], [3, 1, 0], [3, 2, 0], [3, 3, 0]]],
     "oppositeNet": [[[0, 0, 1], [0, 1, 1], [0, 2, 1], [0, 3, 1]], [[1, 0, 2], [1, 1, 2], [1, 2, 2], [1, 3, 2]],
             [[2, 0, 2], [2, 1, 2], [2, 2, 2], [2, 3, 2]], [[3, 0, 1], [3, 1, 1], [3, 2, 1], [3, 3, 1]]],
     "thickness": 0.3, "side": "outside", "worldFromPart": {"rotation": [0.5, 0.5, 0.5, 0.5], "scale": 2}},
    {"name": "cup", "kind": "revolution", "material": "tile",
     "outside": [[[4, 0], [4, 3], [4.5, 6], [5, 9]]], "inside": [[[3.6, 0], [4.6, 9]]],
     "correspondence": "segments", "startAngle": 10, "turnAngle": 270},
    {"name": "spout", "kind": "curvedCylinder", "material": "tile",
     "curve": [[[0, 0, 0], [0, 0, 1], [0, 1, 2], [0, 2, 2]]], "secondRail": [[[1, 0, 0], [1, 2, 2]]],
     "firstAxis": [1, 0, 0], "keepFirstAxis": true, "section": "arc",
     "halfWidth": 0.4, "halfDepth": [[0.5, 0.4, 0.4, 0.3]], "wallThickness": 0.1, "startAngle": -30, "endAngle": 150},
    {"name": "bar", "kind": "network", "file": "bar.data", "format": "lammps",
     "bondTypes": {"1": {"stiffness": 1000, "restLength": 1, "damping": 0.5, "threshold": 0.05}, "2": {"stiffness": 500}}}
  ],
  "glue": [
    {"a": "spout", "b": "cup", "reach": 0.3, "exclude": [1, 2], "region": {"min": [-1, -1, -1], "max": [1, 1, 1]}},
    {"a": "leaf", "b": "brick", "pairs": [[0, 3], [1, 4]]}
  ],
  "environment": {
    "gravity": [0, 0, -4905],
    "colliders": [
      {"name": "floor", "kind": "floor", "position": [0, 0, -1], "friction": 0.6},
      {"name": "table", "kind": "box", "halfSize": [40, 30, 2], "rotation": [0, 5, 0], "stiffness": 1e7},
      {"name": "ball", "kind": "sphere", "radius": 3, "visible": false, "dampingRatio": 0.1,
       "active": [0.1, 0.5]},
      {"name": "pin", "kind": "cylinder", "radius": 1, "halfHeight": 8}
    ]
  },
  "tracks": [
    {"target": "gravity.scale", "keys": [[0, 1], [0.5, 5], [0.6, 1]], "interpolation": "smooth"},
    {"target": "gravity", "keys": [[0, [0, 0, -981]]]},
    {"target": "stiffness.scale", "keys": [[0, 1]]},
    {"target": "damping.scale.clay", "keys": [[0, 1]], "interpolation": "step"},
    {"target": "collider.ball.position", "keys": [[0, [0, 0, 9]], [1, [0, 0, 3]]]},
    {"target": "collider.table.rotation", "keys": [[0, [0, 0, 90]]]}
  ],
  "solver": {"method": "symplectic-euler", "step": 2e-6, "safety": 0.4, "seed": 18446744073709551615,
             "contact": {"between": false, "self": true, "length": "sum", "stiffnessScale": 0.5, "dampingRatio": 0.2,
                         "friction": 0.1}},
  "output": {"fps": 30, "duration": 1.5},
  "view": {"camera": {"position": [1, 2, 3], "target": [0, 0, 5], "fieldOfView": 40, "aperture": 0.5, "focus": 12}, "hidden": ["cup"],
           "locked": ["floor", "cup"]}
}
)";

/// `text` with the first `from` in it replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace tests
