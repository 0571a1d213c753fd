package frustum.files

/** Figures in JSON: an infinite one, as the PSNR of equal pictures, is null. */
object InfinityAsNull {
  def write(v: Double): ujson.Value = if (v.isInfinite) ujson.Null else ujson.Num(v)
  def write(v: Option[Double]): ujson.Value = write(v.getOrElse(Double.PositiveInfinity))
  def read(v: ujson.Value): Double = if (v.isNull) Double.PositiveInfinity else v.num
}
