-- | The language's rules for time, in Copilot: dt is counted in whole nanoseconds.
module ClockInCopilot (nanoseconds, seconds) where

import Language.Copilot
import Prelude ()

-- | The time since the previous instant. Adding and subtracting 2^52 leaves no
-- bits for a fraction. NaN and negative times become 0; the maximum is 10^18.
nanoseconds :: Stream Double
nanoseconds = mux (ns > 0) (mux (ns < big) ((ns + big) - big) (mux (ns < 1e18) ns 1e18)) 0
  where
    ns = extern "dt" Nothing * 1e9
    big = 4503599627370496

seconds :: Stream Double
seconds = nanoseconds / 1e9
