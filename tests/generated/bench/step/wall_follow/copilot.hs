-- The wall follower of the Frob paper (section 3) as a Copilot specification.
module Main (main) where

import ClockInCopilot
import Copilot.Compile.C99 (compile)
import Language.Copilot
import Prelude ()
import qualified Prelude as P

limit :: Stream Double -> Stream Double -> Stream Double
limit x y = mux (y > x) x (mux (y < negate x) (negate x) y)

-- | The slope since the previous instant; the last slope while no time passes.
slope :: Stream Double -> Stream Double
slope s = now
  where
    before = [0] ++ s
    last = [0] ++ now
    started = [False] ++ true
    now = mux (started && (seconds > 0)) ((s - before) / seconds) last

spec :: Spec
spec = trigger "command" true [arg v, arg omega]
  where
    vCurr = extern "v_curr" Nothing
    f = extern "front" Nothing
    s = extern "side" Nothing
    d = 0.2
    v = limit 0.4 (1.0 * (f - d))
    thetaMax = constD (20 P.* P.pi P./ 180)
    omega = 3.0 * (limit (sin thetaMax * vCurr) (0.8 * (s - d)) - slope s)

main :: IO ()
main = reify spec P.>>= compile "copilot"
