-- Follow a wall; back up for 1 s after a bump; turn until the way is clear: a
-- Copilot specification, which has no modes but a stream with the mode's
-- number.
module Main (main) where

import ClockInCopilot
import Copilot.Compile.C99 (compile)
import Language.Copilot
import Prelude ()
import qualified Prelude as P

spec :: Spec
spec = trigger "command" true [arg speed, arg turn]
  where
    bump = extern "bump" Nothing
    side = extern "side" Nothing
    free = extern "front" Nothing > (0.6 :: Stream Double)
    following, backing :: Stream Word8
    following = 0
    backing = 1
    turning = 2
    -- the mode that ran, and the mode that runs
    before = [0] ++ mode
    mode =
      mux ((before == following) && bump && not held) backing $
      mux ((before == backing) && ((since + nanoseconds) >= 1e9)) turning $
      mux ((before == turning) && free && not held) following before
    -- The condition that ends the mode, one instant ago
    held = [True] ++ mux (mode == following) bump (mux (mode == turning) free held)
    since = [0] ++ mux (before == backing) (since + nanoseconds) 0
    started = [False] ++ true
    last = [0] ++ slope
    slope =
      mux (mode /= following) last $
      mux (before /= following) 0 $
      mux (started && (seconds > 0)) ((side - ([0] ++ side)) / seconds) last
    speed, turn :: Stream Double
    speed = mux (mode == following) 0.3 (mux (mode == backing) (-0.2) 0)
    turn = mux (mode == following) (0.8 * (side - 0.5) - 0.3 * slope) (mux (mode == backing) 0 0.8)

main :: IO ()
main = reify spec P.>>= compile "copilot"
