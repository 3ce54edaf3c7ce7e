" Frob: generated from the compiler's tables (compiler/editors/generate).
if exists('b:current_syntax')
  finish
endif

syntax match frobName /\<[a-z_][A-Za-z0-9_']*/
syntax match frobType /\<[A-Z][A-Za-z0-9_']*/
syntax match frobOperator /&&&\|\*\*\*\|\.&\.\|\.|\.\|<<<\|>>>\|\^+\^\|\^-\^\|&&\|\*\*\|\*\^\|-<\|->\|\/=\|::\|<-\|<=\|==\|=>\|>=\|||\|!\|\$\|\*\|+\|-\|\.\|\/\|<\|=\|>\|@\|\\\|\^\||/
syntax match frobNumber /\<\(0[xX][0-9A-Fa-f_]\+\|0[oO][0-7_]\+\|0[bB][01_]\+\|[0-9][0-9_]*\(\.[0-9][0-9_]*\)\?\([eE][+-]\?[0-9]\+\)\?\)/
syntax region frobUnit matchgroup=frobOperator start=/[A-Za-z0-9_']\@<=\[/ end=/\]/ oneline
syntax match frobFunction /^[a-z_][A-Za-z0-9_']*\ze\s*\(,[^=]*\)\?::/
syntax keyword frobDeclaration module import qualified as data type unit primitive class instance foreign param
syntax keyword frobKeyword let in where do of case if then else proc rec
syntax keyword frobPreludeType Float Int Bool String Array SF Task Program Eq Ord Double Integer Time Distance Velocity Acceleration Angle AngularVelocity Maybe Either Event Verdict Claim
syntax keyword frobConstant True False Nothing Just Left Right NoEvent Event NotAsked Holds Open Fails
syntax region frobString start=/"/ skip=/\\./ end=/"/ oneline
syntax region frobComment start=/--/ end=/$/ oneline contains=@Spell
syntax region frobComment start=/{-/ end=/-}/ contains=frobComment,@Spell

highlight default link frobType Type
highlight default link frobPreludeType Type
highlight default link frobOperator Operator
highlight default link frobNumber Number
highlight default link frobUnit Special
highlight default link frobFunction Function
highlight default link frobDeclaration Keyword
highlight default link frobKeyword Keyword
highlight default link frobConstant Constant
highlight default link frobString String
highlight default link frobComment Comment

let b:current_syntax = 'frob'
