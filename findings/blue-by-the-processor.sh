#!/usr/bin/env bash
# Chromium that paints by the processor shows the blue of a BT.709 film 12 levels too dark.
#
# Expected: a film that says it is BT.709 in limited range, whose pixels are Y 32, U 240, V 118, is pure blue: 0, 0, 255
#   within a level or two, however it is painted.
# Happens: painted by a graphics card, or by the program that stands in for one, it is 255. Painted without (--disable-gpu,
#   which is what tests without a screen and remote desktops often have) it is 243: the factor of U in blue is 2.11, and
#   what converts colours there goes as far as 2.
# Versions: chromium 156.0.8078.114-1~deb12u1 of Debian 12.
# Matters: who compares a film with the pictures it was made of, in such a browser, finds a fault that the film has not;
#   BT.601, whose factor is 2.02, hardly shows it. Compare with --use-angle=swiftshader.
set -euo pipefail

version='156.0.8078.114-1~deb12u1'
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir packages && chmod 777 packages
(cd packages && apt-get download --quiet "chromium=$version" "chromium-common=$version" >/dev/null 2>download.log) ||
  { cat packages/download.log; exit 2; }
for package in packages/*.deb; do dpkg -x "$package" unpacked; done

# 64 x 64 pixels of VP9: ffmpeg -f lavfi -i color=blue, converted and marked as above.
cat > film.base64 <<'FILM'
GkXfo59ChoEBQveBAULygQRC84EIQoKEd2VibUKHgQJChYECGFOAZwEAAAAAAAHgEU2bdLpNu4tTq4QVSalmU6yBoU27i1OrhBZUrmtTrIHGTb
uMU6uEElTDZ1OsggEfTbuMU6uEHFO7a1OsggHK7AEAAAAAAABZAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAVSalmoCrXsYMPQkBNgIRMYXZmV0GETGF2ZkSJiEBUAAAAAAAAFl
Sua9SuAQAAAAAAAEvXgQFzxYgAAAAAAAAAAZyBACK1nIN1bmSIgQCGhVZfVlA5g4EBI+ODhAJiWgDgnLCBQLqBQJqBAlWwkFW6gQFVsYEBVbuB
AVW5gQESVMNn1XNz0mPAi2PFiAAAAAAAAAABZ8icRaOHRU5DT0RFUkSHj0xhdmMgbGlidnB4LXZwOWfIokWjiERVUkFUSU9ORIeUMDA6MDA6MD
AuMDgwMDAwMDAwAAAfQ7Z1zOeBAKOygQAAgIJJg0JAA/AD9gA4JBwYAgAAMGAAAGc///+/f6/0//////P674f////7puOomACjk4EAKACGAECS
nABCAAADIAAAVHAcU7trkbuPs4EAt4r3gQHxggF58IED
FILM
cat > page.html <<PAGE
<p id=out>nothing</p><script>
const film = document.createElement('video');
film.muted = true;
film.onloadeddata = () => { film.currentTime = 0.03; };
film.onseeked = () => {
  const canvas = document.createElement('canvas');
  const painter = canvas.getContext('2d');
  painter.drawImage(film, 0, 0);
  out.textContent = 'pixel ' + [...painter.getImageData(32, 32, 1, 1).data].slice(0, 3).join(' ');
};
film.src = 'data:video/webm;base64,$(tr -d '\n' < film.base64)';
</script>
PAGE
pixel() {
  timeout 60 unpacked/usr/lib/chromium/chromium --headless --no-sandbox --user-data-dir="$folder/profile" \
    --virtual-time-budget=8000 --dump-dom "$@" "file://$folder/page.html" 2>/dev/null |
    grep -o 'pixel [0-9 ]*' | head -n 1 || true
}
by_card="$(pixel --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader)"
by_processor="$(pixel --disable-gpu)"
echo "painted as by a graphics card: ${by_card:-nothing}; by the processor: ${by_processor:-nothing}"
[ -n "$by_card" ] && [ -n "$by_processor" ] || exit 2
if [ "${by_card##* }" -ge 253 ] && [ "${by_processor##* }" -le 245 ]; then
  echo 'as described'
else
  echo 'not as described'
  exit 1
fi
