#!/usr/bin/env bash
# Qt's undo stack is not clean after clear(), where it was empty and not clean before.
#
# Expected: QUndoStack::clear() "clears the command stack by deleting all commands on it, and returns the stack to the
#   clean state". So says its page.
# Happens: of a stack that is empty it does nothing at all. One that was made unclean by resetClean(), as it is for a
#   document that was recovered, stays so; and every document that is opened with it afterwards counts as changed,
#   until something is saved.
# Versions: Qt 6.4.2, as packaged in Debian 12 (libqt6gui6, by python3-pyqt6 6.4.2-1).
# Matters: whoever opens one document after another with one stack asks in vain whether to save, and shows a star. Call
#   setClean() after clear().
set -euo pipefail

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir packages && chmod 777 packages
# With all that it needs, as little of it is on every machine.
needed="$(apt-cache depends --recurse --no-recommends --no-suggests --no-conflicts --no-breaks --no-replaces \
  --no-enhances --no-pre-depends python3-pyqt6 | grep -E '^(lib|python3-pyqt6)[a-z0-9.+-]*$' | sort -u |
  grep -vE '^(libc6|libgcc-s1|libstdc\+\+6|libpython.*|libc-bin|libcrypt1)$' || true)"
(cd packages && for package in $needed; do apt-get download --quiet "$package" >/dev/null 2>>download.log || true; done)
[[ -n "$(ls packages/python3-pyqt6_6.4.2-1_*.deb 2>/dev/null)" ]] || { cat packages/download.log; exit 2; }
for package in packages/*.deb; do dpkg -x "$package" unpacked; done
libraries="$(find "$folder/unpacked" -name '*.so*' -printf '%h\n' | sort -u | grep -v python | tr '\n' ':')"
PYTHONPATH="$folder/unpacked/usr/lib/python3/dist-packages" LD_LIBRARY_PATH="$libraries" /usr/bin/python3 - <<'SCRIPT' || status=$?
import sys
try:
    from PyQt6.QtCore import QT_VERSION_STR
    from PyQt6.QtGui import QUndoCommand, QUndoStack
except ImportError as error:
    print('cannot be tried:', error)
    sys.exit(2)

def cleanAfterClear(commands):
    stack = QUndoStack()
    for _ in range(commands):
        stack.push(QUndoCommand())
    stack.resetClean()
    stack.clear()
    return stack.isClean()

some, none = cleanAfterClear(1), cleanAfterClear(0)
print('Qt', QT_VERSION_STR)
print('after resetClean() and clear(), clean?  with a command:', some, ' empty:', none)
sys.exit(0 if some and not none else 1)
SCRIPT
exit "${status:-0}"
