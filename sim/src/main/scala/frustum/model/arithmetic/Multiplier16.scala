package frustum.model.arithmetic

/** 16 x 16 bit product as 32 bits; operands are taken as two's complement where signed, otherwise as
  * 0..65535.
  */
object Multiplier16 {
  def apply(a: Int, b: Int, signedA: Boolean, signedB: Boolean): Int = {
    val x = if (signedA) a.toShort.toInt else a & 0xffff
    val y = if (signedB) b.toShort.toInt else b & 0xffff
    x * y
  }
}
