-- The PID controller as a Copilot specification.
module Main (main) where

import ClockInCopilot
import Copilot.Compile.C99 (compile)
import Language.Copilot
import Prelude ()
import qualified Prelude as P

spec :: Spec
spec = trigger "command" true [arg (mux (wanted > largest) largest (mux (wanted < negate largest) (negate largest) wanted))]
  where
    e = extern "err" Nothing
    kp = 2.0
    ki = 0.3
    kd = 0.1
    largest = 1.0 :: Stream Double
    -- The integral of the counted error, up to the previous instant
    total = ([0] ++ total) + seconds * ([0] ++ counted)
    started = [False] ++ true
    slope = mux (started && (seconds > 0)) ((e - ([0] ++ e)) / seconds) ([0] ++ slope)
    wanted = kp * e + ki * total + kd * slope
    windsUp = (abs wanted > largest) && ((ki * e * wanted) > 0)
    counted = mux windsUp 0 e

main :: IO ()
main = reify spec P.>>= compile "copilot"
